/** Which joints are drawn as bones, and from where to where. */

import type { CastHello } from "../net/protocol";

/** `joint[i]` is drawn as a circle; `segment[k]` runs from joint to joint, parent first. */
export interface BonePlan {
  joints: number[];
  segments: [number, number][];
}

/** The nearest ancestor of `joint` that is drawn, or -1. Parents come before children in `parents`. */
function drawnAncestor(joint: number, parents: readonly number[], drawn: ReadonlySet<number>): number {
  let at = parents[joint] ?? -1;
  while (at >= 0 && !drawn.has(at)) at = parents[at] ?? -1;
  return at;
}

/** Joints a skin names, or all of them where there is no skin; a line for each that hangs on another. */
export function planBones(cast: Pick<CastHello, "nodes" | "parents">, skinJoints: ReadonlySet<number>): BonePlan {
  const all = cast.nodes.map((_, j) => j);
  const named = all.filter((j) => skinJoints.has(cast.nodes[j]!));
  const joints = named.length ? named : all;
  const drawn = new Set(joints);
  const segments = joints.map((j): [number, number] => [drawnAncestor(j, cast.parents, drawn), j]).filter(([parent]) => parent >= 0);
  return { joints, segments };
}
