/** Puts files into one .zip, which the server reads. */

import type { LocalFile } from "./localFiles";

/** A file of the .zip. */
export interface Packed {
  path: string;
  source: LocalFile;
}

const bytesOf = async (file: File): Promise<Uint8Array> => new Uint8Array(await file.arrayBuffer());

/** Returns a .zip of the files, not compressed. */
export async function zipped(name: string, files: readonly Packed[]): Promise<File> {
  const { zipSync } = await import("three/examples/jsm/libs/fflate.module.js");
  const contents = files.map(async ({ path, source }) => [path, await bytesOf(source.file)] as const);
  const entries = Object.fromEntries(await Promise.all(contents));
  return new File([zipSync(entries, { level: 0 })], name);
}
