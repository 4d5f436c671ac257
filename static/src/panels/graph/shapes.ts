/** Boxes, edges and curves, for both layouts of the state graph. */

import type { Edge } from "../../net/protocol";

export interface PlacedState {
  name: string;
  x: number;
  y: number;
  width: number;
}

export interface PlacedEdge extends Edge {
  /** An SVG path. */
  path: string;
  /** Place of the label. */
  x: number;
  y: number;
}

export interface Layout {
  width: number;
  height: number;
  states: PlacedState[];
  edges: PlacedEdge[];
  /** True if only the live state's edges stand out. */
  dense: boolean;
}

export type Point = { x: number; y: number };

export const STATE_HEIGHT = 28;
const CHARACTER_WIDTH = 7.8;

export function stateWidth(name: string): number {
  return Math.max(44, Math.min(160, name.length * CHARACTER_WIDTH + 18));
}

function f(value: number): string {
  return value.toFixed(1);
}

/** Draws a smooth curve along the points, with quadratic corners. */
export function curve(points: readonly Point[]): string {
  const [first, ...rest] = points;
  if (!first || !rest.length) return "";
  let path = `M${f(first.x)} ${f(first.y)}`;
  for (let i = 0; i < rest.length - 1; i++) {
    const [at, next] = [rest[i]!, rest[i + 1]!];
    const end = i === rest.length - 2 ? next : { x: (at.x + next.x) / 2, y: (at.y + next.y) / 2 };
    path += `Q${f(at.x)} ${f(at.y)} ${f(end.x)} ${f(end.y)}`;
  }
  return rest.length === 1 ? `${path}L${f(rest[0]!.x)} ${f(rest[0]!.y)}` : path;
}

/** Draws an edge from a state to itself: a small loop at its upper right corner. */
export function selfLoop({ x, y, width }: PlacedState): Pick<PlacedEdge, "path" | "x" | "y"> {
  const [right, top] = [x + width / 2, y - STATE_HEIGHT / 2];
  const at = (x: number, y: number): string => `${f(x)} ${f(y)}`;
  const curve = [at(right - 20, top - 18), at(right + 18, top - 14), at(right, y - 4)].join(" ");
  const path = `M${at(right - 18, top)}C${curve}`;
  return { path, x: right + 4, y: top - 8 };
}

/** Returns the point at which the line from a box's middle to `to` leaves the box. */
export function borderPoint({ x, y, width }: PlacedState, to: Point): Point {
  const [dx, dy] = [to.x - x, to.y - y];
  const out = Math.min(
    width / 2 / Math.max(Math.abs(dx), 1e-6),
    STATE_HEIGHT / 2 / Math.max(Math.abs(dy), 1e-6),
    1,
  );
  return { x: x + dx * out, y: y + dy * out };
}
