/** How much of each clip a blend has at a place, as the server weighs them (`maths/blending.py`). */

import type { StateInfo } from "../../net/protocol";
import type { Place } from "./blendSpace";

/** Returns the share of each clip, 0…1; the shares sum to 1. */
export function weightsAt(points: StateInfo["points"], place: Place): Record<string, number> {
  const clips = Object.entries(points);
  const weights = clips.map(([, here]) => (here.length > 1 ? inPlane(clips, here, place) : 0));
  if (clips[0]?.[1].length === 1)
    onLine(clips, place[0] ?? 0).forEach((part, clip) => (weights[clip] = part));
  const total = weights.reduce((sum, weight) => sum + weight, 0) || 1;
  return Object.fromEntries(clips.map(([clip], i) => [clip, weights[i]! / total]));
}

/**
 * Returns shares (0…1, sum 1) as whole per cent that sum to 100: what rounding down takes away goes to the largest
 * remainders.
 */
export function wholePercent(shares: Record<string, number>): Record<string, number> {
  const exact = Object.entries(shares).map(([clip, share]) => ({
    clip,
    share: 100 * share,
    whole: Math.floor(100 * share),
  }));
  const left = 100 - exact.reduce((sum, { whole }) => sum + whole, 0);
  const byRemainder = exact.sort((a, b) => b.share - b.whole - (a.share - a.whole));
  return Object.fromEntries(byRemainder.map(({ clip, whole }, i) => [clip, whole + (i < left ? 1 : 0)]));
}

type Clips = readonly (readonly [string, Place])[];

/** Linear between the neighbours. */
function onLine(clips: Clips, value: number): number[] {
  const places = clips.map(([, [at = 0]]) => at);
  const before = Math.max(...places.filter((at) => at <= value), Math.min(...places));
  const after = Math.min(...places.filter((at) => at > before), Math.max(...places));
  const part = after > before ? Math.min(1, Math.max(0, (value - before) / (after - before))) : 0;
  return places.map((at) => (at === before ? 1 - part : at === after ? part : 0));
}

/** Gradient bands: 1 at the clip, 0 from the first other clip on. */
function inPlane(clips: Clips, here: Place, [x = 0, y = 0]: Place): number {
  const [left = 0, low = 0] = here;
  const bands = clips
    .filter(([, other]) => other !== here)
    .map(([, [right = 0, high = 0]]) => {
      const [across, along] = [right - left, high - low];
      const done = ((x - left) * across + (y - low) * along) / (across ** 2 + along ** 2);
      return 1 - Math.min(1, Math.max(0, done));
    });
  return Math.min(1, ...bands);
}
