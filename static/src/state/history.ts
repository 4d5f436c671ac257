/** Keeps the runs of states that this page has seen, for each layer of each actor. */

import { lowerBound } from "./sorted";

/** A state from tick `start` to tick `end`, both included; by name, because an edit may renumber states. */
export interface Run {
  start: number;
  end: number;
  state: string;
}

const MOST_LAYERS = 256;

/** The key of a layer of an actor. */
export function laneKey(actor: number, layer = 0): number {
  return actor * MOST_LAYERS + layer;
}

const MOST_RUNS = 20_000;

/** Joins equal states that follow each other without a gap. */
function joined(runs: readonly Run[]): Run[] {
  const all: Run[] = [];
  for (const run of runs) {
    const last = all.at(-1);
    if (last?.state === run.state && last.end + 1 === run.start) last.end = run.end;
    else all.push({ ...run });
  }
  return all;
}

export class History {
  private runs = new Map<number, Run[]>();
  private gaps = new Set<number>();

  clear(): void {
    this.runs.clear();
    this.gaps.clear();
  }

  /**
   * Enters that `lane` is in `state` at `tick`, as a frame shows it; older ticks are known already and stay.
   * The stream may skip frames: the older state lasts up to this one, unless `markGap` was called or `enter`
   * says when the state changed.
   */
  see(lane: number, tick: number, state: string): void {
    const runs = this.runs.get(lane) ?? [];
    if (!runs.length) this.runs.set(lane, runs);
    const last = runs.at(-1);
    if (last && tick <= last.end) return;
    const isBridged = last !== undefined && !this.gaps.delete(lane);
    if (isBridged) last.end = last.state === state ? tick : tick - 1;
    if (!isBridged || last.state !== state) runs.push({ start: tick, end: tick, state });
    if (runs.length > MOST_RUNS) runs.splice(0, MOST_RUNS / 4);
  }

  /**
   * Enters that `lane` came into `state` at `tick`, as a verdict says. The server sends a verdict when it is on
   * disk, so newer frames may be here already: the state that they bridged lasts up to this tick only.
   */
  enter(lane: number, tick: number, state: string): void {
    const runs = this.runs.get(lane) ?? [];
    const at = lowerBound(runs, tick, (run) => run.end);
    const run = runs[at];
    if (!run || tick < run.start) return this.see(lane, tick, state);
    const parts = [
      { ...run, end: tick - 1 },
      { start: tick, end: run.end, state },
    ].filter(({ start, end }) => start <= end);
    const around = [runs[at - 1], ...parts, runs[at + 1]].filter((part) => part !== undefined);
    const from = Math.max(at - 1, 0);
    runs.splice(from, at + 2 - from, ...joined(around));
  }

  /** Marks a gap: the connection was lost, so the ticks up to the next frame stay unknown. */
  markGap(): void {
    this.gaps = new Set(this.runs.keys());
  }

  /** Replaces the runs up to tick `head` by the server's `changes` of this lane, oldest first. */
  fill(lane: number, changes: readonly { tick: number; state: string }[], head: number): void {
    const known: Run[] = [];
    changes.forEach(({ tick, state }, i) => {
      const end = (changes[i + 1]?.tick ?? head + 1) - 1;
      if (tick <= end) known.push({ start: tick, end, state });
    });
    const later = this.between(lane, head + 1, Infinity).map((run) => ({
      ...run,
      start: Math.max(run.start, head + 1),
    }));
    const [before, after] = [known.at(-1), later[0]];
    // The last state of the answer lasts until the first frame that the page received: no gap after `head`.
    if (before && after) before.end = after.start - 1;
    if (before && after?.state === before.state) later[0] = { ...known.pop()!, end: after.end };
    this.runs.set(lane, [...known, ...later]);
    this.gaps.delete(lane);
  }

  /** Returns the runs of `lane` that overlap the ticks `from`…`to`, oldest first. */
  between(lane: number, from: number, to: number): Run[] {
    const runs = this.runs.get(lane) ?? [];
    const found: Run[] = [];
    for (let i = lowerBound(runs, from, (run) => run.end); i < runs.length && runs[i]!.start <= to; i++)
      found.push(runs[i]!);
    return found;
  }

  /** Returns the state of `lane` at `tick`, or null if it is unknown. */
  stateAt(lane: number, tick: number): string | null {
    return this.between(lane, tick, tick)[0]?.state ?? null;
  }

  /** Returns the newest known state of `lane`, or null. */
  newest(lane: number): string | null {
    return this.between(lane, 0, Infinity).at(-1)?.state ?? null;
  }
}
