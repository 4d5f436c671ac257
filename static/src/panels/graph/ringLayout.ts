/** Places the states of a graph on a ring. */

import { type Plan, type Point, type Size, STATE_HEIGHT, stateWidth } from "./shapes";

const ARROWS_A_STATE = 4;

/** Returns whether a graph has too many edges for a layout in layers. */
export function isDense(states: number, edges: number): boolean {
  return states > 5 && edges > ARROWS_A_STATE * states;
}

/** Places the states clockwise from the top, in the order of the table; neighbours do not overlap. */
export function ringPlan(states: readonly string[], room: Size): Plan {
  const [step, aspect] = [(2 * Math.PI) / states.length, room.width / room.height];
  const widest = Math.max(...states.map(stateWidth));
  const [least, lowest] = [(widest + 10) / step, (STATE_HEIGHT * 1.3) / step];
  const [rx, ry] = [Math.max(least, lowest * aspect), Math.max(lowest, least / aspect)];
  const places = states.map((name, i): [string, Point] => {
    const angle = i * step - Math.PI / 2;
    return [name, { x: rx + rx * Math.cos(angle), y: ry + ry * Math.sin(angle) }];
  });
  return { width: 2 * rx + widest, height: 2 * ry + STATE_HEIGHT, places: new Map(places) };
}
