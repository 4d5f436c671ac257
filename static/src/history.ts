/** What this page has seen of the stage's past: runs of states per actor, and the events that came in. */

import type { LogEntry, Verdict } from "./net/protocol";

/** The state (an index) an actor was in from tick `start` to tick `end`, both included. */
export interface Run {
  start: number;
  end: number;
  state: number;
}

export interface EventMark {
  tick: number;
  actor: number;
  name: string;
  /** A verdict's word, or `logged` for what came in before this page was there. */
  kind: "taken" | "waits" | "dropped" | "logged";
}

const MOST_RUNS = 20_000;
const MOST_MARKS = 20_000;

/** First index in `sorted` whose `key` is at least `value`. */
function lowerBound<T>(sorted: readonly T[], value: number, key: (item: T) => number): number {
  let low = 0;
  let high = sorted.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (key(sorted[middle]!) < value) low = middle + 1;
    else high = middle;
  }
  return low;
}

export class History {
  private runs = new Map<number, Run[]>();
  private torn = new Set<number>();
  private marks: EventMark[] = [];
  private logged: EventMark[] = [];

  clear(): void {
    this.runs.clear();
    this.torn.clear();
    this.marks = [];
    this.logged = [];
  }

  /**
   * The actor is in `state` at `tick`; ticks before the newest one seen are known already and left alone.
   * Frames may be skipped (the newest wins), but no change of state: what lies between two sights of an unbroken line is known.
   */
  see(actor: number, tick: number, state: number): void {
    const runs = this.runs.get(actor) ?? [];
    if (!runs.length) this.runs.set(actor, runs);
    const last = runs.at(-1);
    if (last && tick <= last.end) return;
    const joined = last !== undefined && !this.torn.delete(actor);
    if (joined) last.end = last.state === state ? tick : tick - 1;
    if (!joined || last.state !== state) runs.push({ start: tick, end: tick, state });
    if (runs.length > MOST_RUNS) runs.splice(0, MOST_RUNS / 4);
  }

  /** The line broke: what happens until the next sight stays unknown. */
  tear(): void {
    this.torn = new Set(this.runs.keys());
  }

  /** What the server knows up to tick `head` takes the place of what was seen until then; `changes` are the actor's, oldest first. */
  fill(actor: number, changes: readonly { tick: number; state: number }[], head: number): void {
    const known: Run[] = [];
    changes.forEach(({ tick, state }, i) => {
      const end = (changes[i + 1]?.tick ?? head + 1) - 1;
      if (tick <= end) known.push({ start: tick, end, state });
    });
    const own = this.between(actor, head + 1, Infinity).map((run) => ({ ...run, start: Math.max(run.start, head + 1) }));
    const [before, after] = [known.at(-1), own[0]];
    // The line was whole from the answer's head on: the older state lasts up to the first sight.
    if (before && after) before.end = after.start - 1;
    if (before && after?.state === before.state) own[0] = { ...known.pop()!, end: after.end };
    this.runs.set(actor, [...known, ...own]);
    this.torn.delete(actor);
  }

  /** Runs of `actor` that touch the ticks `from`…`to`, oldest first. */
  between(actor: number, from: number, to: number): Run[] {
    const runs = this.runs.get(actor) ?? [];
    const found: Run[] = [];
    for (let i = lowerBound(runs, from, (run) => run.end); i < runs.length && runs[i]!.start <= to; i++) found.push(runs[i]!);
    return found;
  }

  /** The state `actor` was seen in at `tick`, or null. */
  stateAt(actor: number, tick: number): number | null {
    return this.between(actor, tick, tick)[0]?.state ?? null;
  }

  /** A verdict on an event from outside becomes a mark; END is the motion's own and is none. */
  judge(verdict: Verdict): void {
    if (verdict.event === "END") return;
    this.marks.push({ tick: verdict.tick, actor: verdict.actor, name: verdict.event, kind: verdict.verdict });
    if (this.marks.length > MOST_MARKS) this.marks.splice(0, MOST_MARKS / 4);
  }

  /** The stage's log up to `before`, from where this page's own verdicts go on. */
  remember(entries: readonly LogEntry[], before: number): void {
    const inputs = entries.filter((entry) => (entry.kind === "press" || entry.kind === "hold") && entry.tick <= before);
    this.logged = inputs.map(({ tick, actor, name }) => ({ tick, actor, name: name ?? "", kind: "logged" }));
  }

  /** Marks of `actor` in the ticks `from`…`to`. */
  marksBetween(actor: number, from: number, to: number): EventMark[] {
    const within = (marks: EventMark[]): EventMark[] => {
      const start = lowerBound(marks, from, (mark) => mark.tick);
      return marks.slice(start).filter((mark) => mark.tick <= to && mark.actor === actor);
    };
    return [...within(this.logged), ...within(this.marks)];
  }
}
