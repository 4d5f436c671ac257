/** Calls the part of the REST interface that makes and keeps machines. */

import { ask } from "./api";

/** Makes a machine that is a copy of another one. */
export const copy = (name: string, copy_of: string) =>
  ask("post", "/api/machines", {}, { body: { name, copy_of } });
/** Makes a machine of a simple skeleton at rest. */
export const fromNothing = (name: string) => ask("post", "/api/machines", {}, { body: { name } });
export const rename = (name: string, to: string) =>
  ask("post", "/api/machines/{name}/rename", { name }, { body: { to } });
export const remove = (name: string) => ask("delete", "/api/machines/{name}", { name });
/** Returns the address of a machine as a file. */
export const zipAddress = (name: string): string => `api/machines/${encodeURIComponent(name)}/export.zip`;
