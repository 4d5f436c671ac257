/** Calls the part of the REST interface that makes and keeps machines. */

import { ask } from "./api";
import { askOnce } from "./once";

/** Makes a machine that is a copy of another one. */
export const copy = (name: string, copy_of: string) =>
  askOnce("post", "/api/machines", {}, { body: { name, copy_of } });
/** Makes a machine of a simple skeleton at rest. */
export const fromNothing = (name: string) => askOnce("post", "/api/machines", {}, { body: { name } });
/** Makes a machine of one state, that stands; its character has the clips of `character`. */
export const fromFigure = (name: string, character: string) =>
  askOnce("post", "/api/machines", {}, { body: { name, character, empty: true } });
/**
 * Makes a machine for an uploaded character; a clip with an empty state is left out. `root`: the joint that moves
 * the character through the world.
 */
export const fromCharacter = (name: string, character: string, states: Record<string, string>, root = "") =>
  askOnce("post", "/api/machines", {}, { body: { name, character, mapping: states, root } });
export const rename = (name: string, to: string) =>
  askOnce("post", "/api/machines/{name}/rename", { name }, { body: { to } });
export const remove = (name: string) => ask("delete", "/api/machines/{name}", { name });
/** Asks whether a machine could be renamed or deleted once the stage `besides` is gone; throws why not. */
export const checkUnused = (name: string, besides: string) =>
  ask("get", "/api/machines/{name}/unused", { name }, { query: { besides } });
/** Returns the address of a machine as a file. */
export const zipAddress = (name: string): string => `api/machines/${encodeURIComponent(name)}/export.zip`;
