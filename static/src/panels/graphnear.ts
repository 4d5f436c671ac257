/** Of a machine with very many states only those next to the live one are drawn: the whole would be a thicket. */

import type { Edge } from "../net/protocol";

const MOST_STATES = 40;
const NEAREST = 18;

/** The states to draw, in the order of the table: all, or the live one with those that it leads to and that lead to it, as far as they fit. */
export function statesToDraw(states: readonly string[], edges: readonly Edge[], live: string): string[] {
  if (states.length <= MOST_STATES) return [...states];
  const after = edges.filter(({ from }) => from === live).map(({ to }) => to);
  const before = edges.filter(({ to }) => to === live).map(({ from }) => from);
  const near = new Set([...new Set([live, ...after, ...before])].slice(0, NEAREST));
  return states.filter((name) => near.has(name));
}
