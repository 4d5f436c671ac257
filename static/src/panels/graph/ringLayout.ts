/** Places the states of dense graphs on a ring. */

import { type Point, STATE_HEIGHT, stateWidth } from "./shapes";

const ARROWS_A_STATE = 4;

/** Returns whether a graph has too many edges for a layout in layers. */
export function isDense(states: number, edges: number): boolean {
  return states > 5 && edges > ARROWS_A_STATE * states;
}

/** Places the states clockwise from the top, in the order of the table; neighbours do not overlap. */
export function ringPlaces(states: readonly string[], aspect: number): Map<string, Point> {
  const step = (2 * Math.PI) / states.length;
  const widest = Math.max(...states.map(stateWidth));
  const [least, lowest] = [(widest + 10) / step, (STATE_HEIGHT * 1.3) / step];
  const [rx, ry] = [Math.max(least, lowest * aspect), Math.max(lowest, least / aspect)];
  return new Map(
    states.map((name, i) => {
      const angle = i * step - Math.PI / 2;
      return [name, { x: Math.round(rx + rx * Math.cos(angle)), y: Math.round(ry + ry * Math.sin(angle)) }];
    }),
  );
}
