/** Uploads a model: finds a free name, sends the file, reports progress. */

import { ApiError, characters, machines, problemOf } from "./api";
import type { CharacterSummary, UploadedCharacter } from "./protocol";

const LONGEST_NAME = 56;

/**
 * `Café Robot (2).glb` -> `Cafe-Robot-2`: makes a file name of ASCII letters, digits, `-` and `_` that is not
 * in `taken`.
 */
export function nameFor(file: string, taken: ReadonlySet<string>): string {
  const stem = file
    .replace(/\.[^.]*$/, "")
    .normalize("NFKD")
    .replace(/\p{M}/gu, "");
  const plain =
    stem
      .replace(/[^A-Za-z0-9_-]+/g, "-")
      .replace(/^[-_]+|[-_]+$/g, "")
      .slice(0, LONGEST_NAME) || "character";
  let name = plain;
  for (let number = 2; taken.has(name); number++) name = `${plain}-${number}`;
  return name;
}

/**
 * Names in use: machines, and characters that have a machine. An upload without a machine may be replaced.
 */
export function takenNames(
  machines: readonly { name: string }[],
  characters: readonly CharacterSummary[],
): Set<string> {
  const used = characters.filter(({ uploaded, machine }) => !uploaded || machine !== null);
  return new Set([...machines, ...used].map(({ name }) => name));
}

/** Returns a name for what is made of a file, which nothing has yet. */
export async function freeName(file: string): Promise<string> {
  return nameFor(file, takenNames(...(await Promise.all([machines(), characters()]))));
}

function bodyOf(request: XMLHttpRequest): unknown {
  try {
    return JSON.parse(request.responseText);
  } catch {
    return {};
  }
}

/** How the server reads a file: frames of an .md2, positions of a .bvh, meshes to leave out. */
export interface HowToRead {
  inbetween?: "linear" | "switched";
  position?: "replace" | "add";
  without?: readonly string[];
}

/** Sends `file` to an address; `progress` gets the share sent, 0…1. Rejects with the server's reason. */
function put(
  address: URL,
  file: Blob,
  progress: (share: number) => void,
  signal: AbortSignal,
): Promise<unknown> {
  return new Promise((resolve, reject) => {
    // fetch reports no progress of an upload.
    const request = new XMLHttpRequest();
    request.open("PUT", address);
    request.setRequestHeader("content-type", "application/octet-stream");
    request.upload.addEventListener("progress", ({ loaded, total }) => progress(total ? loaded / total : 0));
    request.upload.addEventListener("load", () => progress(1));
    request.addEventListener("load", () => {
      if (request.status < 300) resolve(bodyOf(request));
      else reject(problemOf(request.status, bodyOf(request)));
    });
    request.addEventListener("error", () =>
      reject(new ApiError(0, "The upload stopped: the file may be too large, or the server is gone.")),
    );
    request.addEventListener("abort", () => reject(new DOMException("aborted", "AbortError")));
    signal.addEventListener("abort", () => request.abort());
    request.send(file);
  });
}

/** Sends `file` as character `name`. */
export async function putCharacter(
  name: string,
  file: Blob,
  progress: (share: number) => void,
  signal: AbortSignal,
  how: HowToRead = {},
): Promise<UploadedCharacter> {
  const address = new URL(`api/characters/${encodeURIComponent(name)}`, document.baseURI);
  const { without = [], ...others } = how;
  const query = [...Object.entries(others), ...without.map((mesh) => ["without", mesh])];
  address.search = new URLSearchParams(query).toString();
  return (await put(address, file, progress, signal)) as UploadedCharacter;
}

/** Makes a machine of a .zip that has a machine.yaml. */
export async function putMachine(
  name: string,
  file: Blob,
  progress: (share: number) => void,
  signal: AbortSignal,
): Promise<void> {
  const path = `api/machines/${encodeURIComponent(name)}/import.zip`;
  await put(new URL(path, document.baseURI), file, progress, signal);
}
