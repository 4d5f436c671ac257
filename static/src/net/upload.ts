/** Uploads a model: finds a free name, sends the file, reports progress. */

import { ApiError, problemOf } from "./api";
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

function bodyOf(request: XMLHttpRequest): unknown {
  try {
    return JSON.parse(request.responseText);
  } catch {
    return {};
  }
}

/** How the server reads a file: frames of an .md2, positions of a .bvh. */
export interface HowToRead {
  inbetween?: "linear" | "switched";
  position?: "replace" | "add";
}

/**
 * Sends `file` as character `name`; `progress` gets the share sent, 0…1. Rejects with the server's reason.
 */
export function putCharacter(
  name: string,
  file: Blob,
  progress: (share: number) => void,
  signal: AbortSignal,
  how: HowToRead = {},
): Promise<UploadedCharacter> {
  return new Promise((resolve, reject) => {
    // fetch reports no progress of an upload.
    const request = new XMLHttpRequest();
    const address = new URL(`api/characters/${encodeURIComponent(name)}`, document.baseURI);
    address.search = new URLSearchParams({ ...how }).toString();
    request.open("PUT", address);
    request.setRequestHeader("content-type", "application/octet-stream");
    request.upload.addEventListener("progress", ({ loaded, total }) => progress(total ? loaded / total : 0));
    request.upload.addEventListener("load", () => progress(1));
    request.addEventListener("load", () => {
      if (request.status < 300) resolve(bodyOf(request) as UploadedCharacter);
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
