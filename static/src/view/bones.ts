/** Decides which joints are drawn as bones. */

import type { CastHello } from "../net/protocol";

/** `joints` are drawn as circles; a segment goes from parent to child. */
export interface BonePlan {
  joints: number[];
  segments: [number, number][];
}

/** Returns the nearest drawn ancestor of `joint`, or -1. */
function drawnAncestor(joint: number, parents: readonly number[], drawn: ReadonlySet<number>): number {
  let at = parents[joint] ?? -1;
  while (at >= 0 && !drawn.has(at)) at = parents[at] ?? -1;
  return at;
}

/**
 * Plans the joints of the skins (all joints if there is no skin), and for each joint a segment from its parent.
 */
export function planBones(
  cast: Pick<CastHello, "nodes" | "parents">,
  skinJoints: ReadonlySet<number>,
): BonePlan {
  const all = cast.nodes.map((_, j) => j);
  const named = all.filter((j) => skinJoints.has(cast.nodes[j]!));
  const joints = named.length ? named : all;
  const drawn = new Set(joints);
  const segments = joints
    .map((j): [number, number] => [drawnAncestor(j, cast.parents, drawn), j])
    .filter(([parent]) => parent >= 0);
  return { joints, segments };
}
