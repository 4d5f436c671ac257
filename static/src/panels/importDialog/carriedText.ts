/** What is said about a capture that was carried over: the joints that it moves, and those that it does not. */

import type { Bones, CarriedClip } from "../../net/protocol";
import { plural } from "../../ui/amounts";

function some(names: readonly string[], most: number): string {
  const more = names.length - most;
  return names.slice(0, most).join(", ") + (more > 0 ? ` and ${more} more` : "");
}

/**
 * Returns the report with the names that matter most first: joints of the character that are bones of a body, and
 * joints of the capture that are none.
 */
export function sorted(report: CarriedClip, capture: Bones, character: Bones): CarriedClip {
  const [ours, theirs] = [capture, character].map(({ bones }) => new Set(Object.values(bones)));
  const by = (names: readonly string[], isFirst: (name: string) => boolean): string[] => [
    ...names.filter(isFirst),
    ...names.filter((name) => !isFirst(name)),
  ];
  return {
    ...report,
    unmapped_source: by(report.unmapped_source, (name) => !ours?.has(name)),
    unmapped_target: by(report.unmapped_target, (name) => theirs?.has(name) ?? false),
  };
}

/** Returns the sentences, with at most so many names in each. */
export function carriedText(report: CarriedClip, most: number): string {
  const { bones, unmapped_source: lost, unmapped_target: still, notes } = report;
  return [
    `${plural(Object.keys(bones).length, "bone")} carried over.`,
    still.length ? `The capture does not move ${some(still, most)}.` : "",
    lost.length ? `Nothing takes the motion of ${some(lost, most)}.` : "",
    ...notes.map((note) => `${note.charAt(0).toUpperCase()}${note.slice(1)}.`),
  ]
    .filter(Boolean)
    .join(" ");
}
