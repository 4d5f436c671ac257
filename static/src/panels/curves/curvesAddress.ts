/** Keeps what is compared in the page's address, so that a reload or a link shows it again. */

import { fault, type Key } from "./keyTable";

/** Returns the query for keys, and for the interpolations (the server's names) that are hidden. */
export function written(keys: readonly Key[], hidden: ReadonlySet<string>): string {
  const query = new URLSearchParams();
  for (const { time, x_deg, y_deg, z_deg, weight } of keys)
    query.append("key", [time, x_deg, y_deg, z_deg, weight].join("_"));
  for (const name of hidden) query.append("without", name);
  return `?${query.toString()}`;
}

/** Returns what a query says; `keys` is null if it has none, or one that cannot be. */
export function read(query: string): { keys: Key[] | null; hidden: Set<string> } {
  const fields = new URLSearchParams(query);
  const keys = fields.getAll("key").map((text): Key => {
    const [time = NaN, x_deg = NaN, y_deg = NaN, z_deg = NaN, weight = NaN] = text.split("_").map(Number);
    return { time, x_deg, y_deg, z_deg, weight };
  });
  return { keys: fault(keys) ? null : keys, hidden: new Set(fields.getAll("without")) };
}
