/** Keeps the user's keys in this browser. */

import { keep, kept } from "./kept";

const PLACE = "statwalk.keys";

type Keys = Record<string, readonly string[]>;

const isKeys = (value: unknown): value is Keys =>
  typeof value === "object" &&
  value !== null &&
  Object.values(value).every((keys) => Array.isArray(keys) && keys.every((key) => typeof key === "string"));

/** Returns the kept keys by the words of their command: none if nothing readable is kept. */
export const keptKeys = (): Keys => kept(PLACE, isKeys, {});

export const keepKeys = (keys: Keys): void => keep(PLACE, keys);
