/** Leads the keyboard from state to state along the arrows. */

import type { Edge } from "../../net/protocol";
import type { Box } from "./shapes";

const DIRECTIONS: Record<string, readonly [number, number]> = {
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
};

/**
 * Returns the state that an arrow key leads to: of the states that an arrow connects with `from` the one that lies
 * best in the key's direction, else of all states; null if none lies there.
 */
export function stateTowards(
  from: string,
  key: string,
  boxes: readonly Box[],
  edges: readonly Edge[],
): string | null {
  const direction = DIRECTIONS[key];
  const here = boxes.find(({ name }) => name === from);
  if (!direction || !here) return null;
  const joined = new Set(edges.flatMap(({ from: a, to: b }) => (a === from ? [b] : b === from ? [a] : [])));
  const best = (candidates: readonly Box[]): string | null => {
    const costs = candidates
      .filter(({ name }) => name !== from)
      .map((box) => ({ name: box.name, cost: cost(here, box, direction) }))
      .filter(({ cost: far }) => far < Infinity);
    return costs.length ? costs.reduce((a, b) => (b.cost < a.cost ? b : a)).name : null;
  };
  return best(boxes.filter(({ name }) => joined.has(name))) ?? best(boxes);
}

/** Returns the distance ahead plus twice the distance aside; Infinity for a box too far aside. */
function cost(here: Box, there: Box, [x, y]: readonly [number, number]): number {
  const [dx, dy] = [there.x - here.x, there.y - here.y];
  const [ahead, aside] = [dx * x + dy * y, Math.abs(dx * y) + Math.abs(dy * x)];
  return ahead > 0 && aside <= ahead * 2 ? ahead + 2 * aside : Infinity;
}
