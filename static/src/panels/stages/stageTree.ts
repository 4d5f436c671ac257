/** Orders stages as a tree over time, and says in words what each is. */

import type { StageInfo } from "../../net/protocol";
import { nameOfStage } from "../../state/stageList";
import { plural } from "../../ui/amounts";

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

function inTime(a: StageInfo, b: StageInfo): number {
  if (a.id === "main" || b.id === "main") return a.id === "main" ? -1 : 1;
  return (a.origin?.tick ?? 0) - (b.origin?.tick ?? 0) || (a.made ?? 0) - (b.made ?? 0);
}

/** Returns where a stage's own ticks begin and end, as shares of the longest time of all stages. */
export function spanOf({ origin, head }: StageInfo, all: readonly StageInfo[]): { from: number; to: number } {
  const longest = Math.max(1, ...all.map((stage) => stage.head));
  return { from: (origin?.tick ?? 0) / longest, to: head / longest };
}

/** Says where a fork left its origin, and what came since. */
export function originWords({ origin, inputs, newest_input }: StageInfo, all: readonly StageInfo[]): string {
  const since = newest_input ? `${plural(inputs, "input")}, the newest: ${newest_input.text}` : "no input";
  if (!origin) return since;
  const parent = all.find(({ id }) => id === origin.stage);
  const from = parent ? nameOfStage(parent) : origin.is_there ? origin.stage : "a deleted stage";
  return `left ${from} at tick ${origin.tick} · ${since}`;
}

/** Says whether the time of a stage goes on, and who watches. */
export function nowWords({ asleep, paused, changed, viewers, head }: StageInfo): string {
  const by = changed?.what === "paused" ? ` by ${changed.by}` : "";
  const clock = asleep ? "asleep" : paused ? `paused${by}` : "runs";
  return `tick ${head} · ${clock} · ${viewers ? plural(viewers, "viewer") : "no viewer"}`;
}
