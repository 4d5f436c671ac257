/** Finds a machine among the files that you drop: a folder with a machine.yaml, or a .zip of one. */

import type { LocalFile } from "./localFiles";
import { zipped } from "./zipped";

const isMachineFile = (path: string): boolean => /(^|\/)machine\.yaml$/.test(path);
const depth = (path: string): number => path.split("/").length;

/** Returns the paths in a .zip; none if it can't be read: the server says what is wrong with it. */
async function pathsIn(file: File): Promise<string[]> {
  const { unzipSync } = await import("three/examples/jsm/libs/fflate.module.js");
  const paths: string[] = [];
  try {
    unzipSync(new Uint8Array(await file.arrayBuffer()), { filter: ({ name }) => !paths.push(name) });
    return paths;
  } catch {
    return [];
  }
}

/** Returns the one .zip to upload, or null if the files are no machine. */
export async function machineAmong(files: readonly LocalFile[]): Promise<File | null> {
  const [main] = files
    .filter(({ path }) => isMachineFile(path))
    .sort((one, other) => depth(one.path) - depth(other.path));
  if (main) {
    const folder = main.path.slice(0, -main.file.name.length);
    const name = folder.split("/").at(-2) ?? "machine";
    const beside = files.filter(({ path }) => path.startsWith(folder));
    return zipped(
      `${name}.zip`,
      beside.map((source) => ({ path: source.path.slice(folder.length), source })),
    );
  }
  const [file] = files;
  const isZip = files.length === 1 && file!.file.name.toLowerCase().endsWith(".zip");
  return isZip && (await pathsIn(file!.file)).some(isMachineFile) ? file!.file : null;
}
