/** Keeps states where they stand: an edit moves no other state, and a new state comes beside its neighbours. */

import type { Edge } from "../../net/protocol";
import { layOut } from "./layout";
import { type Places, type Point, type Size, STATE_HEIGHT, overlap, rectOf, stateWidth } from "./shapes";

/** Between states, with and without room for the label of an arrow. */
const [LABEL_GAP, GAP] = [48, 22];
/** How many rings around its neighbours a new state tries, with each of these gaps. */
const [LABEL_RINGS, RINGS] = [3, 40];

/** Returns the place of each state: its kept one, one beside its neighbours, or of a new layout if none is kept. */
export function placeStates(
  states: readonly string[],
  edges: readonly Edge[],
  kept: ReadonlyMap<string, Point>,
  room: Size,
): Places {
  if (!states.some((name) => kept.has(name))) return layOut(states, edges, room);
  const places: Places = new Map();
  for (const name of states) if (kept.has(name)) places.set(name, kept.get(name)!);
  for (const name of states) if (!places.has(name)) places.set(name, freePlace(name, edges, places));
  return new Map(states.map((name) => [name, places.get(name)!]));
}

/** Returns `kept` with the place of a state under its new name, if one state of the list has another name now. */
export function renamed(
  kept: ReadonlyMap<string, Point>,
  before: readonly string[],
  after: readonly string[],
): ReadonlyMap<string, Point> {
  const differing = before.flatMap((name, i) => (name === after[i] ? [] : [i]));
  const [index] = differing;
  if (before.length !== after.length || differing.length !== 1 || index === undefined) return kept;
  const place = kept.get(before[index]!);
  return place ? new Map([...kept, [after[index]!, place]]) : kept;
}

/** Returns the free place nearest to a state's neighbours, with room for labels if that is near. */
function freePlace(name: string, edges: readonly Edge[], places: Places): Point {
  const beside = edges
    .filter(({ from, to }) => from === name || to === name)
    .flatMap(({ from, to }) => places.get(from === name ? to : from) ?? []);
  const start = middle(beside.length ? beside : [...places.values()]);
  return (
    spotNear(start, name, places, LABEL_GAP, LABEL_RINGS) ??
    spotNear(start, name, places, GAP, RINGS) ??
    start
  );
}

/** Returns the place nearest to `start` with a gap to all states. */
function spotNear(start: Point, name: string, places: Places, gap: number, rings: number): Point | null {
  const [width, height] = [stateWidth(name) + gap, STATE_HEIGHT + gap];
  const taken = [...places].map(([other, place]) =>
    rectOf({ name: other, ...place, width: stateWidth(other) }, gap / 2),
  );
  const free = (place: Point): boolean =>
    !taken.some((rect) => overlap(rect, rectOf({ name, ...place, width: stateWidth(name) })));
  for (let ring = 0; ring < rings; ring++)
    for (const [across, down] of spots(ring)) {
      const place = { x: start.x + (across * width) / 2, y: start.y + down * height };
      if (free(place)) return place;
    }
  return null;
}

function middle(points: readonly Point[]): Point {
  const mean = (values: number[]): number => values.reduce((sum, value) => sum + value, 0) / values.length;
  return { x: mean(points.map(({ x }) => x)), y: mean(points.map(({ y }) => y)) };
}

/** Returns the steps to the places of a square ring, the nearest first. */
function spots(ring: number): [number, number][] {
  const side = Array.from({ length: 2 * ring + 1 }, (_, i) => i - ring);
  return side
    .flatMap((across) => side.map((down): [number, number] => [across, down]))
    .filter(([across, down]) => Math.max(Math.abs(across), Math.abs(down)) === ring)
    .sort((a, b) => Math.hypot(...a) - Math.hypot(...b));
}
