/** The lines that show a joint's limits, in the joint's frame: Y is its axis, sizes in bone lengths. */

import * as THREE from "three";
import type { JointLimit } from "../net/protocol";

const RADIANS = Math.PI / 180;
const STEP = 6 * RADIANS;
/** Radius of arcs and cones. */
const RADIUS = 0.7;

export interface Shape {
  /** Pairs of points (2n, 3): line segments. */
  lines: number[];
  /** Triples of points (3n, 3): faces. */
  faces: number[];
}

type Point = readonly [number, number, number];

/** Adds a curve, and the fan from the origin to it. */
function fan(shape: Shape, curve: readonly Point[], closed: boolean): void {
  for (let k = 0; k + 1 < curve.length; k++) {
    shape.lines.push(...curve[k]!, ...curve[k + 1]!);
    shape.faces.push(0, 0, 0, ...curve[k]!, ...curve[k + 1]!);
  }
  if (!closed) for (const end of [curve[0]!, curve.at(-1)!]) shape.lines.push(0, 0, 0, ...end);
}

/** Adds the arc of a turn about `axis` from `low` to `high`, radians; `start` is the direction at 0. */
export function arc(
  shape: Shape,
  axis: THREE.Vector3,
  start: THREE.Vector3,
  low: number,
  high: number,
  radius = RADIUS,
): void {
  const whole = high - low >= 2 * Math.PI - 1e-6;
  const [from, to] = whole ? [-Math.PI, Math.PI] : [low, high];
  const steps = Math.max(2, Math.ceil((to - from) / STEP));
  const curve = Array.from({ length: steps + 1 }, (_, k): Point => {
    const angle = from + ((to - from) * k) / steps;
    return start.clone().multiplyScalar(radius).applyAxisAngle(axis, angle).toArray();
  });
  fan(shape, curve, whole);
}

/** Returns where Y points after a swing by the rotation vector (x, 0, z). */
export function swung(x: number, z: number): THREE.Vector3 {
  const angle = Math.hypot(x, z);
  const axis = angle ? new THREE.Vector3(x / angle, 0, z / angle) : new THREE.Vector3(1, 0, 0);
  return new THREE.Vector3(0, RADIUS, 0).applyAxisAngle(axis, angle);
}

/** Returns the edge of a swing's limits at an angle around the axis. */
function edge(limit: JointLimit, around: number): [number, number] {
  const [x, z] = limit.freedoms as [JointLimit["freedoms"][0], JointLimit["freedoms"][0]];
  const [cos, sin] = [Math.cos(around), Math.sin(around)];
  const half = (cos < 0 ? x.minimum! : x.maximum!) * RADIANS;
  const other = (sin < 0 ? z.minimum! : z.maximum!) * RADIANS;
  if (limit.shape === "cone") return [Math.abs(half) * cos, Math.abs(other) * sin];
  const grown = 1 / Math.max(Math.abs(cos), Math.abs(sin));
  const middle = [(x.minimum! + x.maximum!) / 2, (z.minimum! + z.maximum!) / 2].map((v) => v * RADIANS);
  const halves = [(x.maximum! - x.minimum!) / 2, (z.maximum! - z.minimum!) / 2].map((v) => v * RADIANS);
  return [middle[0]! + halves[0]! * cos * grown, middle[1]! + halves[1]! * sin * grown];
}

/** Adds the cone, or the pyramid, in which Y may swing. */
function cone(shape: Shape, limit: JointLimit): void {
  const curve = Array.from({ length: 73 }, (_, k): Point => swung(...edge(limit, k * 5 * RADIANS)).toArray());
  fan(shape, curve, true);
  for (let k = 0; k < 72; k += 18) shape.lines.push(0, 0, 0, ...curve[k]!);
}

/** Adds a rail from `low` to `high` along an axis, with a bar across at its ends; metres. */
function rail(shape: Shape, axis: THREE.Vector3, across: THREE.Vector3, low: number, high: number): void {
  const at = (along: number, side: number): Point =>
    axis.clone().multiplyScalar(along).addScaledVector(across, side).toArray();
  shape.lines.push(...at(low, 0), ...at(high, 0));
  for (const end of [low, high]) shape.lines.push(...at(end, -0.12), ...at(end, 0.12));
}

/** The direction from which turns about an axis are measured: of the bone, as far as it is across the axis. */
function startOf(bone: THREE.Vector3, axis: THREE.Vector3): THREE.Vector3 {
  const start = bone.clone().addScaledVector(axis, -bone.dot(axis));
  return start.lengthSq() > 0.05
    ? start.normalize()
    : new THREE.Vector3(...(axis.x ? ([0, 1, 0] as const) : ([1, 0, 0] as const)));
}

/**
 * Returns where on the shape of a joint's limits it shows that degrees of freedom have these values, by name:
 * on an arc, at the end of a swing, on a rail. Degrees and metres; `bone` and `metres` as in `limitShape`.
 */
export function markAt(
  limit: JointLimit,
  values: ReadonlyMap<string, number>,
  bone: THREE.Vector3,
  metres: number,
): THREE.Vector3 {
  const of = (name: string): number => values.get(name) ?? 0;
  const [name] = values.keys();
  if (name?.startsWith("swing")) return swung(of("swing_x") * RADIANS, of("swing_z") * RADIANS);
  if (name?.startsWith("slide_"))
    return new THREE.Vector3(of("slide_x"), 0, of("slide_z")).divideScalar(metres);
  if (name === "slide") return new THREE.Vector3(0, of("slide") / metres, 0);
  const letter = name?.at(-1);
  const axis = new THREE.Vector3(+(letter === "x"), 0, +(letter === "z"));
  if (!axis.lengthSq()) axis.y = 1;
  if (name?.startsWith("translate")) return axis.multiplyScalar(of(name) / metres);
  const mark = startOf(bone, axis)
    .multiplyScalar(name === "twist" ? RADIUS / 2 : RADIUS)
    .applyAxisAngle(axis, of(name ?? "") * RADIANS);
  if (limit.type === "helical") mark.y += (limit.pitch * of("angle")) / 360 / metres;
  return mark;
}

/** Returns the shape of a joint's limits; `bone`: the direction of bone B at rest, metres a bone length. */
export function limitShape(limit: JointLimit, bone: THREE.Vector3, metres: number): Shape {
  const shape: Shape = { lines: [], faces: [] };
  const [x, y, z] = [new THREE.Vector3(1, 0, 0), new THREE.Vector3(0, 1, 0), new THREE.Vector3(0, 0, 1)];
  if (limit.shape === "cone" || limit.shape === "range") cone(shape, limit);
  for (const { name, minimum, maximum } of limit.freedoms) {
    const [low, high] = [minimum ?? -180, maximum ?? 180];
    if (name === "angle") arc(shape, y, startOf(bone, y), low * RADIANS, high * RADIANS);
    if (name === "twist" && high - low < 359.9)
      arc(shape, y, startOf(bone, y), low * RADIANS, high * RADIANS, RADIUS / 2);
    if (name.startsWith("rotate") && high > low && high - low < 359.9) {
      const axis = { x, y, z }[name.at(-1) as "x" | "y" | "z"];
      arc(shape, axis, startOf(bone, axis), low * RADIANS, high * RADIANS);
    }
    if (/^(slide|translate)/.test(name) && minimum !== null && maximum !== null && high > low) {
      const axis = name.endsWith("_x") ? x : name.endsWith("_z") ? z : y;
      rail(shape, axis, axis === x ? z : x, low / metres, high / metres);
    }
  }
  return shape;
}
