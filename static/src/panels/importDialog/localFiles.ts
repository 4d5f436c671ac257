/** The files that were dropped or chosen, with their paths; a dropped folder is read through. */

import { size } from "../../ui/amounts";

/** The server closes the connection on a larger file, which a page cannot tell from a lost connection. */
const MOST_BYTES = 64 * 2 ** 20;

export interface LocalFile {
  /** The path below what was dropped, or the file's name. */
  path: string;
  file: File;
}

/** Larger folders are not read to their end. */
export const MOST_FILES = 1000;

const named = (file: File): LocalFile => ({ path: file.webkitRelativePath || file.name, file });

function fileOf(entry: FileSystemFileEntry): Promise<LocalFile> {
  return new Promise((resolve, reject) =>
    entry.file((file) => resolve({ path: entry.fullPath.replace(/^\//, ""), file }), reject),
  );
}

/** Returns the entries of a folder; the browser hands them out in batches, an empty one at the end. */
async function entriesOf(folder: FileSystemDirectoryEntry): Promise<FileSystemEntry[]> {
  const reader = folder.createReader();
  const entries: FileSystemEntry[] = [];
  for (;;) {
    const batch = await new Promise<FileSystemEntry[]>((resolve, reject) =>
      reader.readEntries(resolve, reject),
    );
    if (!batch.length || entries.length > MOST_FILES) return entries;
    entries.push(...batch);
  }
}

async function below(entries: FileSystemEntry[]): Promise<LocalFile[]> {
  const files: LocalFile[] = [];
  const open = [...entries];
  for (let entry = open.shift(); entry && files.length < MOST_FILES; entry = open.shift()) {
    if (entry.isFile) files.push(await fileOf(entry as FileSystemFileEntry));
    else open.push(...(await entriesOf(entry as FileSystemDirectoryEntry)));
  }
  return files;
}

/** Returns the files that a drag carries. Must be called in the event: afterwards the drag is empty. */
export function droppedFiles(carried: DataTransfer): Promise<LocalFile[]> {
  const plain = [...carried.files].map(named);
  const entries = [...carried.items].map((item) => item.webkitGetAsEntry());
  const folders = entries.some((entry) => entry?.isDirectory);
  return folders ? below(entries.filter((entry) => entry !== null)) : Promise.resolve(plain);
}

/** Returns the files of a file input. */
export const chosenFiles = (input: HTMLInputElement): LocalFile[] => [...(input.files ?? [])].map(named);

/** Throws if the server would not take as many bytes. */
export function checkSize(files: readonly LocalFile[]): void {
  const total = files.reduce((sum, { file }) => sum + file.size, 0);
  if (total > MOST_BYTES)
    throw new Error(`The files have ${size(total)}; the server takes ${size(MOST_BYTES)} at most.`);
}
