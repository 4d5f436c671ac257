/** Where the handle of a point or a direction stands in the scene, and which value a place in the scene means. */

import * as THREE from "three";
import type { Point } from "../../state/points";

export interface Frame {
  /** From model space to the scene; null: the numbers are on the stage. */
  root: THREE.Matrix4 | null;
  /** Where the direction begins in the scene; null: it is a point. */
  from: Point | null;
  /** Metres from there to the handle of a direction. */
  away: number;
}

/** Metres: a handle nearer than this to where its direction begins shows no direction. */
const NEAREST = 1e-6;

/** The place of the handle in the scene. */
export function placeOf(value: Point, { root, from, away }: Frame): Point {
  const vector = new THREE.Vector3(...value);
  if (!from) return (root ? vector.applyMatrix4(root) : vector).toArray();
  if (root) vector.transformDirection(root);
  return vector
    .setLength(away)
    .add(new THREE.Vector3(...from))
    .toArray();
}

/** The value of a handle at a place in the scene: a point, or a direction of length 1; null: it has none. */
export function valueAt(place: Point, { root, from }: Frame): Point | null {
  const vector = new THREE.Vector3(...place);
  const back = root?.clone().invert();
  if (!from) return (back ? vector.applyMatrix4(back) : vector).toArray();
  vector.sub(new THREE.Vector3(...from));
  if (vector.length() < NEAREST) return null;
  return (back ? vector.transformDirection(back) : vector.normalize()).toArray();
}
