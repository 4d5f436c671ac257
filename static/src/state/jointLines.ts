/** The difference of two stages, or of two spans, by joint, in words, the farthest joint first. */

import type { StageDifferences } from "../net/protocol";
import type { JointLine } from "../ui/jointTable";

/** Returns the joints of an actor that differ; without it those of the first actor. */
export function jointLines({ actors }: StageDifferences, actor: number | null): JointLine[] {
  const compared = actors.find(({ id }) => id === actor) ?? actors[0];
  if (!compared) return [];
  const { joints, joint_distance, joint_angle_deg } = compared;
  return joints
    .map((joint, j) => ({ joint, distance: joint_distance[j]!, angle: joint_angle_deg[j]! }))
    .sort((a, b) => b.distance - a.distance)
    .map(({ joint, distance, angle }) => ({
      joint,
      distance: (100 * distance).toFixed(1),
      angle: angle.toFixed(1),
    }))
    .filter(({ distance, angle }) => Number(distance) > 0 || Number(angle) > 0);
}

/** Says of which ticks the numbers of these lines are, or why there are none. */
export function comparedWords(difference: StageDifferences, lines: number): string {
  const { from, to, with_from, note, first_difference } = difference;
  if (note) return note;
  const beside = with_from === from ? "" : `, beside those from ${with_from} on`;
  const ticks = (from === to ? `at tick ${from}` : `in the ticks ${from} to ${to}`) + beside;
  if (lines) return `The largest differences ${ticks}:`;
  return first_difference === null
    ? `No joint differs ${ticks}.`
    : `No joint differs by half a millimetre, or a twentieth of a degree, ${ticks}.`;
}
