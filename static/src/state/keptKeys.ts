/** Keeps the user's keys in this browser. */

const PLACE = "statwalk.keys";

type Keys = Record<string, readonly string[]>;

const isKeys = (value: unknown): value is Keys =>
  typeof value === "object" &&
  value !== null &&
  Object.values(value).every((keys) => Array.isArray(keys) && keys.every((key) => typeof key === "string"));

/** Returns the kept keys by the words of their command: none if nothing readable is kept. */
export function keptKeys(): Keys {
  try {
    const value: unknown = JSON.parse(localStorage.getItem(PLACE) ?? "{}");
    return isKeys(value) ? value : {};
  } catch {
    return {};
  }
}

/** A browser that keeps nothing has the keys until the page is closed. */
export function keepKeys(keys: Keys): void {
  try {
    localStorage.setItem(PLACE, JSON.stringify(keys));
  } catch {
    return;
  }
}
