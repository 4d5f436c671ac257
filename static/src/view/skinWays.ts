/**
 * Gives skins the geometry of one of the four ways: blended matrices or dual quaternions, each vertex with its
 * heaviest bone, or torn into pieces that go with one bone each. The server's rules are in `skin/skinning.py`.
 */

import * as THREE from "three";
import type { Skinning } from "../net/protocol";

const rigid = new WeakMap<THREE.BufferGeometry, THREE.BufferGeometry>();
const torn = new WeakMap<THREE.BufferGeometry, THREE.BufferGeometry>();

function kept<K extends WeakKey, V>(map: WeakMap<K, V>, key: K, make: (key: K) => V): V {
  const value = map.get(key) ?? make(key);
  map.set(key, value);
  return value;
}

interface Shares {
  bones: number[];
  weights: number[];
}

/** Returns the bones and weights of some vertices, one after the other. */
export function sharesOf({ attributes }: THREE.BufferGeometry, vertices: readonly number[]): Shares {
  const shares: Shares = { bones: [], weights: [] };
  for (const [joints, weights] of [
    [attributes["skinIndex"], attributes["skinWeight"]],
    [attributes["moreJoints"], attributes["moreWeights"]],
  ])
    for (const vertex of joints && weights ? vertices : [])
      for (let k = 0; k < 4; k++) {
        shares.bones.push(joints!.getComponent(vertex, k));
        shares.weights.push(weights!.getComponent(vertex, k));
      }
  return shares;
}

/** Returns the bone with the largest sum of weights; of bones equal to four decimals the first of the skin. */
export function heaviestBone({ bones, weights }: Shares): number {
  const sum = (bone: number): number => bones.reduce((all, b, k) => all + (b === bone ? weights[k]! : 0), 0);
  const sums = bones.map((bone) => Math.round(1e4 * sum(bone)));
  const most = Math.max(...sums);
  return Math.min(...bones.filter((_, k) => sums[k] === most));
}

/** Gives each vertex one bone; `boneOf` returns it. */
function bind(geometry: THREE.BufferGeometry, boneOf: (vertex: number) => number): THREE.BufferGeometry {
  const count = geometry.attributes.position!.count;
  const [bones, weights] = [new Uint16Array(4 * count), new Float32Array(4 * count)];
  for (let vertex = 0; vertex < count; vertex++) {
    bones[4 * vertex] = boneOf(vertex);
    weights[4 * vertex] = 1;
  }
  geometry.setAttribute("skinIndex", new THREE.BufferAttribute(bones, 4));
  geometry.setAttribute("skinWeight", new THREE.BufferAttribute(weights, 4));
  return geometry.deleteAttribute("moreJoints").deleteAttribute("moreWeights");
}

/** Returns a geometry that shares all arrays. */
function sharing(geometry: THREE.BufferGeometry): THREE.BufferGeometry {
  const copy = new THREE.BufferGeometry();
  for (const [name, attribute] of Object.entries(geometry.attributes)) copy.setAttribute(name, attribute);
  copy.setIndex(geometry.index);
  copy.morphAttributes = geometry.morphAttributes;
  copy.morphTargetsRelative = geometry.morphTargetsRelative;
  for (const group of geometry.groups) copy.addGroup(group.start, group.count, group.materialIndex);
  return copy;
}

export function rigidGeometry(geometry: THREE.BufferGeometry): THREE.BufferGeometry {
  return bind(sharing(geometry), (vertex) => heaviestBone(sharesOf(geometry, [vertex])));
}

/** Returns triangles with corners of their own. */
export function tornGeometry(geometry: THREE.BufferGeometry): THREE.BufferGeometry {
  const pieces = geometry.index ? geometry.toNonIndexed() : sharing(geometry);
  const bones: number[] = [];
  for (let corner = 0; corner < pieces.attributes.position!.count; corner += 3)
    bones.push(heaviestBone(sharesOf(pieces, [corner, corner + 1, corner + 2])));
  return bind(pieces, (vertex) => bones[Math.floor(vertex / 3)]!);
}

/** Returns a skin's geometry in a way; lines and points stay whole. */
export function geometryIn(
  geometry: THREE.BufferGeometry,
  way: Skinning,
  triangles: boolean,
): THREE.BufferGeometry {
  if (way === "rigid" || (way === "parts" && !triangles)) return kept(rigid, geometry, rigidGeometry);
  return way === "parts" ? kept(torn, geometry, tornGeometry) : geometry;
}
