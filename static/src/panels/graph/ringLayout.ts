/** Lays out dense graphs: states on a ring, edges as chords. */

import type { Edge } from "../../net/protocol";
import { type Layout, type PlacedState, STATE_HEIGHT, borderPoint, selfLoop, stateWidth } from "./shapes";

const ARROWS_A_STATE = 4;
const MARGIN = 34;

/** Returns whether a graph has too many edges for a layout in layers. */
export function isDense(states: number, edges: number): boolean {
  return states > 5 && edges > ARROWS_A_STATE * states;
}

/**
 * Returns the half axes of a ring with the given `aspect` (width over height) on which neighbours do not
 * overlap.
 */
function ringSize(states: readonly string[], aspect: number): { rx: number; ry: number } {
  const step = (2 * Math.PI) / states.length;
  const widest = Math.max(...states.map(stateWidth));
  const [rx, ry] = [(widest + 10) / step, (STATE_HEIGHT * 1.3) / step];
  return { rx: Math.max(rx, ry * aspect), ry: Math.max(ry, rx / aspect) };
}

/** Draws a chord between two boxes, bent towards the middle of the ring. */
function chord(
  from: PlacedState,
  to: PlacedState,
  middle: { x: number; y: number },
): { path: string; x: number; y: number } {
  const bend = 0.45;
  const [x, y] = [
    ((from.x + to.x) / 2) * (1 - bend) + middle.x * bend,
    ((from.y + to.y) / 2) * (1 - bend) + middle.y * bend,
  ];
  const [a, b] = [borderPoint(from, { x, y }), borderPoint(to, { x, y })];
  const at = (x: number, y: number): string => `${x.toFixed(1)} ${y.toFixed(1)}`;
  const path = `M${at(a.x, a.y)}Q${at(x, y)} ${at(b.x, b.y)}`;
  return { path, x: (a.x + b.x) / 4 + x / 2, y: (a.y + b.y) / 4 + y / 2 };
}

/** Places the states clockwise from the top, in the order of the table. */
export function ringLayout(states: readonly string[], edges: readonly Edge[], aspect: number): Layout {
  const { rx, ry } = ringSize(states, aspect);
  const middle = { x: rx + MARGIN + 40, y: ry + MARGIN };
  const placed = states.map((name, i) => {
    const angle = (i / states.length) * 2 * Math.PI - Math.PI / 2;
    return {
      name,
      x: middle.x + rx * Math.cos(angle),
      y: middle.y + ry * Math.sin(angle),
      width: stateWidth(name),
    };
  });
  const where = new Map(placed.map((state) => [state.name, state]));
  const draw = ({ from, to }: Edge): { path: string; x: number; y: number } =>
    from === to ? selfLoop(where.get(from)!) : chord(where.get(from)!, where.get(to)!, middle);
  return {
    width: middle.x * 2,
    height: middle.y * 2,
    states: placed,
    edges: edges.map((edge) => ({ ...edge, ...draw(edge) })),
    dense: true,
  };
}
