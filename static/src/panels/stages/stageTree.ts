/** Orders stages as a tree over time, and says in words what each is. */

import type { StageInfo } from "../../net/protocol";
import { nameOf } from "../../state/stageList";

export interface Row {
  stage: StageInfo;
  depth: number;
}

/** Returns each stage below its origin, forks in the order of their ticks; main comes first. */
export function treeOf(stages: readonly StageInfo[]): Row[] {
  const known = new Set(stages.map(({ id }) => id));
  const parentOf = ({ origin }: StageInfo): string | null =>
    origin && known.has(origin.stage) ? origin.stage : null;
  const below = (parent: string | null, depth: number): Row[] =>
    stages
      .filter((stage) => parentOf(stage) === parent)
      .sort(inTime)
      .flatMap((stage) => [{ stage, depth }, ...below(stage.id, depth + 1)]);
  return below(null, 0);
}

function inTime(one: StageInfo, other: StageInfo): number {
  if (one.id === "main" || other.id === "main") return one.id === "main" ? -1 : 1;
  return (one.origin?.tick ?? 0) - (other.origin?.tick ?? 0) || (one.made ?? 0) - (other.made ?? 0);
}

const counted = (count: number, noun: string): string => `${count} ${noun}${count === 1 ? "" : "s"}`;

/** Says where a fork left its origin, and what came since. */
export function originWords({ origin, inputs, newest_input }: StageInfo, all: readonly StageInfo[]): string {
  const since = newest_input ? `${counted(inputs, "input")}, the newest: ${newest_input.text}` : "no input";
  if (!origin) return since;
  const parent = all.find(({ id }) => id === origin.stage);
  const from = parent ? nameOf(parent) : origin.is_there ? origin.stage : "a deleted stage";
  return `left ${from} at tick ${origin.tick} · ${since}`;
}

/** Says whether the time of a stage goes on, and who watches. */
export function nowWords({ asleep, paused, changed, viewers, head }: StageInfo): string {
  const by = changed?.what === "paused" ? ` by ${changed.by}` : "";
  const clock = asleep ? "asleep" : paused ? `paused${by}` : "runs";
  return `tick ${head} · ${clock} · ${viewers === 1 ? "1 watches" : `${viewers} watch`}`;
}
