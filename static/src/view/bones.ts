/** Decides which joints are drawn as bones. */

import type { CastHello } from "../net/protocol";

/** `joints` are drawn as circles; a segment goes from parent to child. */
export interface BonePlan {
  joints: number[];
  segments: [number, number][];
}

/** What a plan reads of a cast; without `muscle_bones` it has none. */
export type BoneRows = Pick<CastHello, "nodes" | "parents"> & Partial<Pick<CastHello, "muscle_bones">>;

/** Returns the nearest drawn ancestor of `joint`, or -1. */
function drawnAncestor(joint: number, parents: readonly number[], drawn: ReadonlySet<number>): number {
  let at = parents[joint] ?? -1;
  while (at >= 0 && !drawn.has(at)) at = parents[at] ?? -1;
  return at;
}

/**
 * Plans the joints of the skins (all joints if there is no skin), and for each joint a segment from its parent.
 * Muscle bones only deform the skin: they have no segment.
 */
export function planBones(cast: BoneRows, skinJoints: ReadonlySet<number>): BonePlan {
  const all = cast.nodes.map((_, j) => j);
  const named = all.filter((j) => skinJoints.has(cast.nodes[j]!));
  const joints = named.length ? named : all;
  const muscles = new Set(cast.muscle_bones);
  const bones = joints.filter((j) => !muscles.has(j));
  const drawn = new Set(bones);
  const segments = bones
    .map((j): [number, number] => [drawnAncestor(j, cast.parents, drawn), j])
    .filter(([parent]) => parent >= 0);
  return { joints, segments };
}
