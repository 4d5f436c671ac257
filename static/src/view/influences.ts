/**
 * Gives vertices the matrices that they follow: as the server does (`skin/weights.py`), all sets of influences
 * count, negative weights are none, weights sum to 1, and the largest comes first.
 */

import * as THREE from "three";

/** The influences of a vertex that the GPU blends. */
export const MOST_INFLUENCES = 8;

type Attribute = THREE.BufferAttribute | THREE.InterleavedBufferAttribute;

/** Returns the sets of influences: three reads glTF's first set, and keeps the others by their name. */
function setsOf({ attributes }: THREE.BufferGeometry): [joints: Attribute, weights: Attribute][] {
  const sets: [Attribute, Attribute][] = [];
  let [joints, weights] = [attributes["skinIndex"], attributes["skinWeight"]];
  while (joints && weights) {
    sets.push([joints, weights]);
    [joints, weights] = [attributes[`joints_${sets.length}`], attributes[`weights_${sets.length}`]];
  }
  return sets;
}

/** Returns the influences of a vertex, the largest first; without any weight the first joint counts. */
function influencesOf(
  sets: readonly (readonly [Attribute, Attribute])[],
  vertex: number,
): [joint: number, weight: number][] {
  const found: [number, number][] = [];
  for (const [joints, weights] of sets)
    for (let k = 0; k < 4; k++) {
      const weight = weights.getComponent(vertex, k);
      if (weight > 0) found.push([joints.getComponent(vertex, k), weight]);
    }
  if (!found.length) return [[sets[0]![0].getComponent(vertex, 0), 1]];
  const sum = found.reduce((all, [, weight]) => all + weight, 0);
  for (const influence of found) influence[1] /= sum;
  return found.sort((a, b) => b[1] - a[1]);
}

/** The attributes of a vertex: its first four influences, and four more if any vertex has them. */
export interface Influences {
  attributes: Record<string, THREE.BufferAttribute>;
  /** The influences of the vertex that has most. */
  most: number;
}

function attributesOf(
  rows: readonly (readonly [number, number][])[],
  first: number,
): THREE.BufferAttribute[] {
  const [joints, weights] = [new Uint16Array(4 * rows.length), new Float32Array(4 * rows.length)];
  rows.forEach((row, vertex) => {
    for (let k = 0; k < 4; k++) {
      const [joint, weight] = row[first + k] ?? [row[0]![0], 0];
      joints[4 * vertex + k] = joint;
      weights[4 * vertex + k] = weight;
    }
  });
  return [new THREE.BufferAttribute(joints, 4), new THREE.BufferAttribute(weights, 4)];
}

/** Makes the attributes; `offset` is added to the index of each joint. */
export function influences(geometry: THREE.BufferGeometry, offset: number): Influences {
  const sets = setsOf(geometry);
  const { count } = geometry.getAttribute("position");
  const rows = Array.from({ length: count }, (_, vertex): [number, number][] =>
    sets.length
      ? influencesOf(sets, vertex).map(([joint, weight]) => [offset + joint, weight])
      : [[offset, 1]],
  );
  const most = rows.reduce((longest, row) => Math.max(longest, row.length), 0);
  const [skinIndex, skinWeight] = attributesOf(rows, 0) as [THREE.BufferAttribute, THREE.BufferAttribute];
  if (most <= 4) return { attributes: { skinIndex, skinWeight }, most };
  const [moreJoints, moreWeights] = attributesOf(rows, 4) as [THREE.BufferAttribute, THREE.BufferAttribute];
  return { attributes: { skinIndex, skinWeight, moreJoints, moreWeights }, most };
}
