/** Calls the part of the REST interface that edits machines and goes through their versions. */

import { ask } from "./api";
import { askOnce } from "./once";
import type { Operation } from "./protocol";

/** The key of an edit that shall be kept, which counts once however often it is sent; null: it is only verified. */
type Key = string | null;
const how = (key: Key): { key: string } | { query: { dry: true } } =>
  key === null ? { query: { dry: true } } : { key };

/** Applies operations as one version, if nothing that they touch has changed since `version`. */
export const patchMachine = (name: string, version: number, operations: readonly Operation[], key: Key) =>
  ask(
    "patch",
    "/api/machines/{name}",
    { name },
    { body: { operations: [...operations] }, version, ...how(key) },
  );
/** Replaces the machine's whole text, if the machine is still at `version`. */
export const putMachine = (name: string, version: number, text: string, key: Key) =>
  ask("put", "/api/machines/{name}", { name }, { body: { text }, version, ...how(key) });
export const undo = (name: string, version: number) =>
  askOnce("post", "/api/machines/{name}/undo", { name }, { version });
export const redo = (name: string, version: number) =>
  askOnce("post", "/api/machines/{name}/redo", { name }, { version });
/** Makes a new version with the text of version `number`. */
export const restore = (name: string, version: number, number: number) =>
  askOnce("post", "/api/machines/{name}/versions/{number}/restore", { name, number }, { version });
export const versions = (name: string) => ask("get", "/api/machines/{name}/versions", { name });
/** Reads what version `number` says otherwise than version `since`. */
export const differences = (name: string, number: number, since: number) =>
  ask("get", "/api/machines/{name}/versions/{number}/differences", { name, number }, { query: { since } });
