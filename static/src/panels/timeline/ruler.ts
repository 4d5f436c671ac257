/** The ruler over the lanes: marks at round seconds. */

import { type Span } from "../../state/timelineWindow";
import { type LaneCanvas, place } from "./lanes";
import { RULER_HEIGHT } from "./laneRows";

/** Steps between marks, seconds. */
const STEPS_S = [0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 1800, 3600, 7200, 21600];
/** Between two marks at least, pixels. */
const ROOM = 64;

export interface RulerMark {
  tick: number;
  words: string;
}

/** Writes seconds as `0.25 s`, `12 s` or `3:05`. */
export function secondsText(seconds: number, step: number): string {
  if (step < 1) return `${seconds.toFixed(step < 0.1 ? 2 : 1)} s`;
  if (seconds < 60) return `${Math.round(seconds)} s`;
  const [minutes, rest] = [Math.floor(seconds / 60), Math.round(seconds % 60)];
  return `${minutes}:${String(rest).padStart(2, "0")}`;
}

/** Returns the marks of a span that is drawn `width` pixels wide; `rate`: ticks per second. */
export function rulerMarks({ from, to }: Span, rate: number, width: number): RulerMark[] {
  const seconds = Math.max(to - from, 1) / rate;
  const step = STEPS_S.find((each) => (each / seconds) * width >= ROOM) ?? STEPS_S.at(-1)!;
  const [first, last] = [Math.ceil(from / rate / step - 1e-9), Math.floor(to / rate / step + 1e-9)];
  return Array.from({ length: Math.max(0, last - first + 1) }, (_, k) => {
    const at = (first + k) * step;
    return { tick: at * rate, words: secondsText(at, step) };
  });
}

export function drawRuler({ pen, span, width, ink }: LaneCanvas, marks: readonly RulerMark[]): void {
  pen.font = ink.font;
  pen.textBaseline = "middle";
  pen.fillStyle = ink.quiet;
  for (const { tick, words } of marks) {
    const x = place(tick, span, width);
    pen.fillRect(x, RULER_HEIGHT - 5, 1, 5);
    if (x + 4 + pen.measureText(words).width < width) pen.fillText(words, x + 4, RULER_HEIGHT / 2);
  }
}
