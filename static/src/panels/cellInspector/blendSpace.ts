/** The blend of a state as numbers: its axes, where its clips stand, and what an edit says of them. */

import type { Marker, Operation, Parameter, StateInfo } from "../../net/protocol";
import { listed } from "../../state/fieldTexts";

/** A parameter, or another value, over which clips are blended, with the range that is drawn. */
export interface Axis {
  name: string;
  least: number;
  most: number;
  /** The parameter; null: the value is no parameter, so the page cannot set it. */
  parameter: Parameter | null;
}

/** The blend's place along each axis: one number, or two. */
export type Place = readonly number[];

/** Steps of the keyboard from one end of an axis to the other. */
const STEPS = 20;

/** Returns the axes of a blend; a range holds its parameter's bounds and all clips. */
export function axesOf({ over, points }: StateInfo, parameters: readonly Parameter[]): Axis[] {
  return over.map((name, i) => {
    const parameter = parameters.find((known) => known.name === name) ?? null;
    const bounds = parameter ? [parameter.minimum, parameter.maximum].filter(Number.isFinite) : [];
    const all = [...Object.values(points).map((place) => place[i] ?? 0), ...bounds];
    const [least, most] = [Math.min(...all), Math.max(...all)];
    return { name, least, most: most > least ? most : least + 1, parameter };
  });
}

/** Returns where a value lies on its axis, 0…1. */
export const along = ({ least, most }: Axis, value: number): number => (value - least) / (most - least);

/** Returns the value at a part of an axis, without more digits than the axis can show. */
export function valueAt({ least, most }: Axis, part: number): number {
  const digits = Math.max(0, 3 - Math.ceil(Math.log10(most - least)));
  const value = least + Math.min(1, Math.max(0, part)) * (most - least);
  return Number(value.toFixed(digits));
}

/** Returns a place with each value within its axis. */
export const clamped = (axes: readonly Axis[], place: Place): number[] =>
  axes.map(({ least, most }, i) => Math.min(most, Math.max(least, place[i] ?? least)));

/** Returns the place in the middle of all axes. */
export const middle = (axes: readonly Axis[]): number[] => axes.map((axis) => valueAt(axis, 0.5));

/** Returns the place that an arrow key leads to, or null if it is none. */
export function stepped(axes: readonly Axis[], place: Place, key: string): number[] | null {
  const [axis, by] =
    { ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowDown: [1, -1], ArrowUp: [1, 1] }[key] ?? [];
  if (axis === undefined || by === undefined || !axes[axis]) return null;
  return place.map((value, i) =>
    i === axis ? valueAt(axes[i]!, along(axes[i]!, value) + by / STEPS) : value,
  );
}

/** Reads as many numbers as there are axes. :throws: if there are more or fewer, in words for the user. */
export function placeOf(text: string, axes: readonly Axis[]): number[] {
  const place = text.split(",").map((part) => (part.trim() ? Number(part) : NaN));
  if (place.length !== axes.length || place.some(Number.isNaN))
    throw new Error(axes.length === 1 ? "one number" : "two numbers with a comma between them");
  return place;
}

/** Returns the operations that put a clip of a blend at a place. */
export const putClip = (
  state: { state: string; layer: string },
  clip: string,
  [x = 0, y]: Place,
): Operation[] => [{ kind: "set_blend_clip", ...state, clip, at: y === undefined ? x : [x, y] }];

/** Returns the operations that make the parameters of a blend that the machine does not have. */
const missing = (over: readonly string[], parameters: readonly Parameter[]): Operation[] =>
  over
    .filter((name) => !/\s/.test(name) && !parameters.some((known) => known.name === name))
    .map((name) => ({ kind: "add_parameter", name, fields: { default: 0, min: 0, max: 1, smooth: 0.2 } }));

/**
 * Returns the operations that make a blend of a state's one clip and another: over the parameter `over`, which is made
 * if the machine does not have it.
 */
export function makeBlend(
  state: { state: string; layer: string },
  clips: readonly [string, string],
  over: string,
  parameters: readonly Parameter[],
): Operation[] {
  const known = parameters.find(({ name }) => name === over);
  const [least, most] = known ? [known.minimum, known.maximum] : [0, 1];
  const motion = { over, clips: { [clips[0]]: least, [clips[1]]: most } };
  return [...missing([over], parameters), { kind: "set_state", ...state, fields: { motion } }];
}

/** Returns the phases of the markers that the machine's file sets. */
const written = (markers: readonly Marker[]): Record<string, number> =>
  Object.fromEntries(markers.filter((marker) => marker.written).map(({ name, phase }) => [name, phase]));

/**
 * Returns the operations that make a blend one of its clips. The clip keeps its markers; phases that the state itself
 * sets are phases of the first clip.
 */
export function oneClip(
  state: { state: string; layer: string },
  { clips, clip_markers, markers }: StateInfo,
  clip: string,
): Operation[] {
  const [ofClip, ofState] = [written(clip_markers[clip] ?? []), written(markers)];
  const kept = clip === clips[0] ? { ...ofClip, ...ofState } : { ...ofState, ...ofClip };
  const fields = { motion: clip, ...(Object.keys(kept).length && { markers: kept }) };
  return [{ kind: "set_state", ...state, fields }];
}

/** Returns the operations that blend a state's clips over other values: one, or two with a comma between them. */
export function blendOver(
  state: { state: string; layer: string },
  { points, clip_markers }: StateInfo,
  text: string,
  parameters: readonly Parameter[],
): Operation[] {
  const over = listed(text);
  if (over.length < 1 || over.length > 2) throw new Error("a parameter, or two with a comma between them");
  const clips = Object.fromEntries(
    Object.entries(points).map(([clip, [x = 0, y = 0]]) => [clip, over.length > 1 ? [x, y] : x]),
  );
  const marked = Object.entries(clip_markers)
    .map(([clip, markers]) => [clip, written(markers)] as const)
    .filter(([, phases]) => Object.keys(phases).length);
  const motion = {
    over: over.length > 1 ? over : over[0]!,
    clips,
    ...(marked.length && { markers: Object.fromEntries(marked) }),
  };
  return [...missing(over, parameters), { kind: "set_state", ...state, fields: { motion } }];
}
