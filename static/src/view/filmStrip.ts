/** Makes a film strip: goes to moments of a span one after the other, and takes a picture of each. */

import type { Span } from "../state/timelineWindow";
import type { App } from "./app";
import { capture, type Moment, strip } from "./pictures";

/** Moments of a strip. */
const MOMENTS = 8;
/** The server answers within this time, or the strip is given up. */
const PATIENCE_MS = 20_000;

/** Returns the ticks of so many moments of a span, evenly, its first and last among them. */
export function momentsOf({ from, to }: Span, count = MOMENTS): number[] {
  const all = Array.from({ length: count }, (_, k) => Math.round(from + ((to - from) * k) / (count - 1)));
  return [...new Set(all)];
}

/** Shows a tick, and returns once it is drawn; throws if the server does not answer. */
async function goTo({ playback, view }: App, tick: number): Promise<void> {
  const start = performance.now();
  playback.look(tick);
  while (view.posed !== tick) {
    if (performance.now() - start > PATIENCE_MS) throw new Error(`Tick ${tick} has not come.`);
    await new Promise(requestAnimationFrame);
  }
}

/** Returns the strip of a span; the page shows afterwards what it has shown before. */
export async function filmStrip(app: App, span: Span, transparent: boolean): Promise<HTMLCanvasElement> {
  const { playback, stage, view } = app;
  const before = playback.looking.value;
  playback.replaying.value = false;
  const moments: Moment[] = [];
  try {
    for (const tick of momentsOf(span)) {
      await goTo(app, tick);
      view.scene.view.catchUp();
      const words = `${(tick / stage.rate).toFixed(2)} s`;
      moments.push({ picture: capture(view.scene, transparent), words });
    }
  } finally {
    if (before === null) playback.live();
    else playback.look(before);
  }
  return strip(moments);
}
