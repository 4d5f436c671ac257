/** Puts the states of two spans of the timeline side by side. */

import type { Run } from "../../state/history";
import type { Span } from "../../state/timelineWindow";

/** A line of the comparison: the n-th state of each span, with its length in words; empty: the span has no more. */
export interface ComparedLine {
  first: string;
  second: string;
  /** Whether the states, or their lengths, differ. */
  differs: boolean;
}

interface Stay {
  state: string;
  ticks: number;
}

/** Cuts the runs to a span. */
function staysIn({ from, to }: Span, runs: readonly Run[]): Stay[] {
  return runs
    .map(({ start, end, state }) => ({ state, ticks: Math.min(end, to) - Math.max(start, from) + 1 }))
    .filter(({ ticks }) => ticks > 0);
}

/** Compares the runs of two spans in their order; `rate`: ticks per second. */
export function compareSpans(
  [one, runs]: readonly [Span, readonly Run[]],
  [other, otherRuns]: readonly [Span, readonly Run[]],
  rate: number,
): ComparedLine[] {
  const [stays, others] = [staysIn(one, runs), staysIn(other, otherRuns)];
  const words = (stay: Stay | undefined): string =>
    stay ? `${stay.state} ${(stay.ticks / rate).toFixed(2)} s` : "";
  return Array.from({ length: Math.max(stays.length, others.length) }, (_, k) => ({
    first: words(stays[k]),
    second: words(others[k]),
    differs: stays[k]?.state !== others[k]?.state || stays[k]?.ticks !== others[k]?.ticks,
  }));
}
