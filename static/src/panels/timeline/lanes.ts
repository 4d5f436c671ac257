/** Draws the timeline's lanes: states as coloured segments, blends as wedges, events and actions as marks. */

import type { ActionMark, BlendSpan, EventMark } from "../../state/eventLog";
import type { Run } from "../../state/history";
import type { Span } from "../../state/timelineWindow";
import { ACTION_HEIGHT, BLEND_HEIGHT, EVENT_HEIGHT, type LayerRows, STATE_HEIGHT } from "./laneRows";

/** Returns the x of `tick` in a lane of `width` pixels. */
export function place(tick: number, { from, to }: Span, width: number): number {
  return ((tick - from) / Math.max(1, to - from)) * width;
}

/** Returns the tick at `x`: the nearest of `marked` within `reach` pixels, else the tick at that place. */
export function tickAt(
  x: number,
  span: Span,
  width: number,
  marked: readonly number[],
  reach: number,
): number {
  const tick = Math.round(span.from + (x / Math.max(1, width)) * (span.to - span.from));
  const near = marked
    .map((mark) => ({ mark, far: Math.abs(place(mark, span, width) - x) }))
    .filter(({ far }) => far <= reach);
  const nearest = near.sort((a, b) => a.far - b.far)[0]?.mark ?? tick;
  return Math.min(span.to, Math.max(span.from, nearest));
}

/** Returns the colour of state `index`: distinct hues, less saturated than the accent. */
export function stateColour(index: number, dark: boolean): string {
  const hue = (215 + index * 137.508) % 360;
  return dark ? `oklch(0.46 0.075 ${hue.toFixed(0)})` : `oklch(0.83 0.07 ${hue.toFixed(0)})`;
}

/** Extends the newest run to `head`: while the past is shown, verdicts still report changes of state. */
export function upTo(runs: readonly Run[], head: number): Run[] {
  return runs.map((run, i) => (i === runs.length - 1 ? { ...run, end: Math.max(run.end, head) } : run));
}

export interface LaneInk {
  dark: boolean;
  text: string;
  quiet: string;
  accent: string;
  /** For ticks without a known state. */
  empty: string;
  font: string;
}

/** The canvas, and the span of ticks that it shows. */
export interface LaneCanvas {
  pen: CanvasRenderingContext2D;
  span: Span;
  width: number;
  ink: LaneInk;
}

/** Draws runs of states; `number` returns a state's index in its layer, or -1. */
export function drawRuns(
  { pen, span, width, ink }: LaneCanvas,
  runs: readonly Run[],
  { state: top }: LayerRows,
  number: (state: string) => number,
): void {
  pen.fillStyle = ink.empty;
  pen.fillRect(0, top, width, STATE_HEIGHT);
  pen.font = ink.font;
  pen.textBaseline = "middle";
  for (const run of runs) {
    const left = Math.max(0, place(run.start, span, width));
    const size = Math.max(1, place(run.end + 1, span, width) - left);
    const known = number(run.state);
    pen.fillStyle = known < 0 ? ink.empty : stateColour(known, ink.dark);
    pen.fillRect(left, top, size > 3 ? size - 1 : size, STATE_HEIGHT);
    if (size < 26 || pen.measureText(run.state).width + 12 > size) continue;
    pen.fillStyle = ink.text;
    pen.fillText(run.state, left + 6, top + STATE_HEIGHT / 2 + 0.5);
  }
}

/** Draws a wedge for each blend: high at its start, zero at its end. */
export function drawBlends(
  { pen, span, width, ink }: LaneCanvas,
  blends: readonly BlendSpan[],
  { blend: top }: LayerRows,
): void {
  pen.fillStyle = ink.quiet;
  for (const { tick, end } of blends) {
    const [left, right] = [place(tick, span, width), place(end, span, width)];
    pen.beginPath();
    pen.moveTo(left, top);
    pen.lineTo(Math.max(right, left + 1.5), top);
    pen.lineTo(left, top + BLEND_HEIGHT);
    pen.fill();
  }
}

const MARK_ROOM = 11;

/** Draws an event: taken is a bar in the accent colour, waiting a hollow bar, dropped a short quiet bar. */
function drawMark({ pen, ink }: LaneCanvas, kind: EventMark["kind"], x: number, top: number): void {
  const waits = kind === "waits" || kind === "logged";
  pen.fillStyle = kind === "taken" ? ink.accent : waits ? ink.text : ink.quiet;
  if (kind === "dropped") pen.fillRect(x - 0.5, top + 1, 1, 3);
  else pen.fillRect(x - 0.75, top + 1, 1.5, 5);
  if (!waits) return;
  pen.fillStyle = ink.empty;
  pen.fillRect(x - 0.25, top + 2, 0.5, 3);
}

const SIZE: Record<EventMark["kind"], number> = { taken: 2, logged: 1, waits: 1, dropped: 0 };

export function drawMarks(sheet: LaneCanvas, marks: readonly EventMark[], { events: top }: LayerRows): void {
  const { pen, span, width, ink } = sheet;
  let free = -MARK_ROOM;
  // Taken events are drawn last, on top.
  for (const mark of [...marks].sort((a, b) => SIZE[a.kind] - SIZE[b.kind]))
    drawMark(sheet, mark.kind, place(mark.tick, span, width), top);
  pen.font = ink.font;
  for (const mark of marks) {
    const x = place(mark.tick, span, width);
    if (x - free < MARK_ROOM) continue;
    free = x;
    pen.globalAlpha = mark.kind === "dropped" ? 0.55 : 1;
    pen.fillStyle = mark.kind === "taken" ? ink.accent : ink.quiet;
    pen.fillText(mark.name.slice(0, 1), x - 3, top + EVENT_HEIGHT / 2 + 3.5);
  }
  pen.globalAlpha = 1;
}

/** Draws a diamond for each action, with its name if there is room. */
export function drawActions(
  { pen, span, width, ink }: LaneCanvas,
  actions: readonly ActionMark[],
  top: number,
): void {
  const middle = top + ACTION_HEIGHT / 2;
  pen.font = ink.font;
  actions.forEach(({ tick, name }, i) => {
    const x = place(tick, span, width);
    const next = i + 1 < actions.length ? place(actions[i + 1]!.tick, span, width) : width;
    pen.fillStyle = ink.text;
    pen.beginPath();
    for (const [dx, dy] of [
      [0, -4],
      [4, 0],
      [0, 4],
      [-4, 0],
    ] as const)
      pen.lineTo(x + dx, middle + dy);
    pen.fill();
    if (pen.measureText(name).width + 16 > next - x) return;
    pen.fillStyle = ink.quiet;
    pen.fillText(name, x + 7, middle + 0.5);
  });
}

/** Draws a selected span over the lanes. */
export function drawSelection(
  { pen, span, width }: LaneCanvas,
  { from, to }: Span,
  height: number,
  colour: string,
): void {
  const [left, right] = [place(from, span, width), place(to, span, width)];
  pen.fillStyle = colour;
  pen.globalAlpha = 0.22;
  pen.fillRect(left, 0, right - left, height);
  pen.globalAlpha = 1;
  for (const x of [left, right]) pen.fillRect(x - 0.5, 0, 1, height);
}

/** Draws the line of the shown tick with its grip. */
export function drawHead({ pen, ink }: LaneCanvas, x: number, height: number): void {
  pen.fillStyle = ink.accent;
  pen.fillRect(x - 1, 4, 2, height - 4);
  pen.beginPath();
  pen.arc(x, 5, 4.5, 0, Math.PI * 2);
  pen.fill();
}
