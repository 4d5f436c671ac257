/** What this page has seen of the stage's past: runs of states, for each layer of each actor. */

import { lowerBound } from "./sorted";

/** The state an actor was in from tick `start` to tick `end`, both included; by name, since an edit may number states anew. */
export interface Run {
  start: number;
  end: number;
  state: string;
}

const MOST_LAYERS = 256;

/** The number under which a layer of an actor is remembered. */
export function lineOf(actor: number, layer = 0): number {
  return actor * MOST_LAYERS + layer;
}

const MOST_RUNS = 20_000;

export class History {
  private runs = new Map<number, Run[]>();
  private torn = new Set<number>();

  clear(): void {
    this.runs.clear();
    this.torn.clear();
  }

  /**
   * The layer `line` is in `state` at `tick`; ticks before the newest one seen are known already and left alone.
   * Frames may be skipped (the newest wins), but no change of state: what lies between two sights of an unbroken line is known.
   */
  see(line: number, tick: number, state: string): void {
    const runs = this.runs.get(line) ?? [];
    if (!runs.length) this.runs.set(line, runs);
    const last = runs.at(-1);
    if (last && tick <= last.end) return;
    const joined = last !== undefined && !this.torn.delete(line);
    if (joined) last.end = last.state === state ? tick : tick - 1;
    if (!joined || last.state !== state) runs.push({ start: tick, end: tick, state });
    if (runs.length > MOST_RUNS) runs.splice(0, MOST_RUNS / 4);
  }

  /** The line broke: what happens until the next sight stays unknown. */
  tear(): void {
    this.torn = new Set(this.runs.keys());
  }

  /** What the server knows up to tick `head` takes the place of what was seen until then; `changes` are the line's, oldest first. */
  fill(line: number, changes: readonly { tick: number; state: string }[], head: number): void {
    const known: Run[] = [];
    changes.forEach(({ tick, state }, i) => {
      const end = (changes[i + 1]?.tick ?? head + 1) - 1;
      if (tick <= end) known.push({ start: tick, end, state });
    });
    const own = this.between(line, head + 1, Infinity).map((run) => ({ ...run, start: Math.max(run.start, head + 1) }));
    const [before, after] = [known.at(-1), own[0]];
    // The line was whole from the answer's head on: the older state lasts up to the first sight.
    if (before && after) before.end = after.start - 1;
    if (before && after?.state === before.state) own[0] = { ...known.pop()!, end: after.end };
    this.runs.set(line, [...known, ...own]);
    this.torn.delete(line);
  }

  /** Runs of `line` that touch the ticks `from`…`to`, oldest first. */
  between(line: number, from: number, to: number): Run[] {
    const runs = this.runs.get(line) ?? [];
    const found: Run[] = [];
    for (let i = lowerBound(runs, from, (run) => run.end); i < runs.length && runs[i]!.start <= to; i++) found.push(runs[i]!);
    return found;
  }

  /** The state `line` was seen in at `tick`, or null. */
  stateAt(line: number, tick: number): string | null {
    return this.between(line, tick, tick)[0]?.state ?? null;
  }
}
