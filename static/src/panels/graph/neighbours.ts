/** Picks the states to draw: in a large machine the live state and its neighbours only. */

import type { Edge } from "../../net/protocol";

export const MOST_STATES = 40;
const NEAREST = 18;

/**
 * Returns all states, or, above MOST_STATES, the live state with its successors and predecessors; in the
 * order of the table.
 */
export function statesToDraw(states: readonly string[], edges: readonly Edge[], live: string): string[] {
  if (states.length <= MOST_STATES) return [...states];
  const after = edges.filter(({ from }) => from === live).map(({ to }) => to);
  const before = edges.filter(({ to }) => to === live).map(({ from }) => from);
  const near = new Set([...new Set([live, ...after, ...before])].slice(0, NEAREST));
  return states.filter((name) => near.has(name));
}
