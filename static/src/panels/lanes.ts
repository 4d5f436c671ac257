/** The lanes of the timeline as a drawing: states as coloured segments, events as ticks. */

import type { EventMark, Run } from "../history";

export interface Span {
  from: number;
  to: number;
}

/** The part of the history that is shown: all of it, or the last `window` ticks; what one looks at is always within. */
export function spanOf(first: number, head: number, window: number | null, looking: number | null): Span {
  const newest = Math.max(head, first + 1);
  const from = window === null ? first : Math.max(first, newest - window);
  return { from: looking === null ? from : Math.min(from, looking), to: newest };
}

/** Where `tick` lies across `width` pixels. */
export function place(tick: number, { from, to }: Span, width: number): number {
  return ((tick - from) / Math.max(1, to - from)) * width;
}

/** The colour of state `index`: hues far apart, quiet enough to leave the accent alone. */
export function stateColour(index: number, dark: boolean): string {
  const hue = (215 + index * 137.508) % 360;
  return dark ? `oklch(0.46 0.075 ${hue.toFixed(0)})` : `oklch(0.83 0.07 ${hue.toFixed(0)})`;
}

export interface LaneInk {
  dark: boolean;
  text: string;
  quiet: string;
  accent: string;
  /** Where nothing was seen. */
  empty: string;
  font: string;
}

export const STATE_LANE = { top: 10, height: 20 };
export const EVENT_LANE = { top: 34, height: 14 };

export function drawRuns(pen: CanvasRenderingContext2D, runs: readonly Run[], span: Span, width: number, ink: LaneInk, name: (state: number) => string): void {
  pen.fillStyle = ink.empty;
  pen.fillRect(0, STATE_LANE.top, width, STATE_LANE.height);
  pen.font = ink.font;
  pen.textBaseline = "middle";
  for (const run of runs) {
    const left = Math.max(0, place(run.start, span, width));
    const size = Math.max(1, place(run.end + 1, span, width) - left);
    pen.fillStyle = stateColour(run.state, ink.dark);
    pen.fillRect(left, STATE_LANE.top, size > 3 ? size - 1 : size, STATE_LANE.height);
    const label = name(run.state);
    if (size < 26 || pen.measureText(label).width + 12 > size) continue;
    pen.fillStyle = ink.text;
    pen.fillText(label, left + 6, STATE_LANE.top + STATE_LANE.height / 2 + 0.5);
  }
}

const MARK_ROOM = 11;

export function drawMarks(pen: CanvasRenderingContext2D, marks: readonly EventMark[], span: Span, width: number, ink: LaneInk): void {
  let free = -MARK_ROOM;
  for (const mark of marks) {
    const x = place(mark.tick, span, width);
    pen.globalAlpha = mark.kind === "dropped" ? 0.35 : mark.kind === "waits" ? 0.6 : 1;
    pen.fillStyle = mark.kind === "dropped" ? ink.quiet : ink.accent;
    pen.fillRect(x - 0.75, STATE_LANE.top + STATE_LANE.height + 2, 1.5, 5);
    if (x - free >= MARK_ROOM) {
      free = x;
      pen.fillStyle = ink.quiet;
      pen.fillText(mark.name.slice(0, 1), x - 3, EVENT_LANE.top + EVENT_LANE.height / 2 + 4);
    }
  }
  pen.globalAlpha = 1;
}

/** The line of the tick that is shown, with a grip on top. */
export function drawHead(pen: CanvasRenderingContext2D, x: number, height: number, ink: LaneInk): void {
  pen.fillStyle = ink.accent;
  pen.fillRect(x - 1, 4, 2, height - 4);
  pen.beginPath();
  pen.arc(x, 5, 4.5, 0, Math.PI * 2);
  pen.fill();
}
