/** Projects the bones of an answer onto the plane of a drawing: turned about the upright axis, fitted in. */

import type { DeducedBone } from "../../net/protocol";

export interface Segment {
  name: string;
  from: [number, number];
  to: [number, number];
  kind: "known" | "deduced" | "unknown";
}

/** Tells whether both ends of a bone were given, were deduced, or are not known. */
export function kindOf(bone: DeducedBone): Segment["kind"] {
  const sources = [bone.values["SP"]?.source, bone.values["EP"]?.source];
  if (sources.includes(undefined)) return "unknown";
  return sources.every((source) => source === "given") ? "known" : "deduced";
}

/** Returns the bones as segments within `size` pixels, seen after a turn by `degrees`. */
export function segments(bones: readonly DeducedBone[], degrees: number, size: number): Segment[] {
  const [c, s] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
  const flat = ([x, y, z]: readonly number[]): [number, number] => [c * (x ?? 0) + s * (z ?? 0), -(y ?? 0)];
  const points = bones.map(({ start, end }) => [flat(start), flat(end)] as const);
  const all = points.flat();
  const low = [0, 1].map((axis) => Math.min(...all.map((point) => point[axis] ?? 0)));
  const high = [0, 1].map((axis) => Math.max(...all.map((point) => point[axis] ?? 0)));
  const span = Math.max(...high.map((top, axis) => top - (low[axis] ?? 0)), 1e-9);
  const margin = 0.08 * size;
  const place = (point: readonly number[]): [number, number] => {
    const [x = 0, y = 0] = point.map(
      (value, axis) =>
        size / 2 + ((value - ((low[axis] ?? 0) + (high[axis] ?? 0)) / 2) / span) * (size - 2 * margin),
    );
    return [x, y];
  };
  return bones.map((bone, row) => {
    const [from, to] = points[row] ?? [
      [0, 0],
      [0, 0],
    ];
    return { name: bone.name, from: place(from), to: place(to), kind: kindOf(bone) };
  });
}
