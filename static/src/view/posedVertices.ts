/** Poses vertices on this computer, for boxes: matrices blended by weight, after the morph targets. */

import * as THREE from "three";

type Attribute = THREE.BufferAttribute | THREE.InterleavedBufferAttribute;

/** Adds to `out` (x y z) what one set of influences of a vertex makes of the point `at`. */
function follow(
  out: THREE.Vector3,
  at: THREE.Vector3,
  pose: Float32Array,
  joints: Attribute,
  weights: Attribute,
  vertex: number,
): void {
  for (let k = 0; k < 4; k++) {
    const weight = weights.getComponent(vertex, k);
    if (weight === 0) continue;
    const m = 16 * joints.getComponent(vertex, k);
    out.x += weight * (pose[m]! * at.x + pose[m + 4]! * at.y + pose[m + 8]! * at.z + pose[m + 12]!);
    out.y += weight * (pose[m + 1]! * at.x + pose[m + 5]! * at.y + pose[m + 9]! * at.z + pose[m + 13]!);
    out.z += weight * (pose[m + 2]! * at.x + pose[m + 6]! * at.y + pose[m + 10]! * at.z + pose[m + 14]!);
  }
}

/**
 * Adds every `step`th vertex of a part to a box; `pose` has the actor's matrices, and from `firstWeight` on its
 * morph weights.
 */
export function growBox(
  box: THREE.Box3,
  { attributes, morphAttributes }: THREE.BufferGeometry,
  pose: Float32Array,
  firstWeight: number,
  step: number,
): void {
  const { position, skinIndex, skinWeight, moreJoints, moreWeights } = attributes;
  const targets = morphAttributes["position"] ?? [];
  const [at, moved, target] = [new THREE.Vector3(), new THREE.Vector3(), new THREE.Vector3()];
  for (let vertex = 0; vertex < position!.count; vertex += step) {
    at.fromBufferAttribute(position!, vertex);
    targets.forEach((offsets, k) => {
      const weight = pose[firstWeight + k]!;
      if (weight) at.addScaledVector(target.fromBufferAttribute(offsets, vertex), weight);
    });
    moved.set(0, 0, 0);
    follow(moved, at, pose, skinIndex!, skinWeight!, vertex);
    if (moreJoints && moreWeights) follow(moved, at, pose, moreJoints, moreWeights, vertex);
    box.expandByPoint(moved);
  }
}
