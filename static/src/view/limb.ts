/** The chain of joints that a dragged joint pulls along. */

/**
 * Returns the joints from the start of a limb to `joint`: up to below the next joint from which several bones go
 * out. `parents` of all joints; `drawn`: those that are bones.
 */
export function limbOf(joint: number, parents: readonly number[], drawn: ReadonlySet<number>): number[] {
  const above = (at: number): number => {
    let next = parents[at] ?? -1;
    while (next >= 0 && !drawn.has(next)) next = parents[next] ?? -1;
    return next;
  };
  const branches = new Map<number, number>();
  for (const at of drawn) branches.set(above(at), (branches.get(above(at)) ?? 0) + 1);
  const limb = [joint];
  for (let at = above(joint); at >= 0 && branches.get(at) === 1; at = above(at)) limb.unshift(at);
  return limb;
}
