/** What can be done with the selected span: loop it, save it, look at it closely. */

import "./spanBar.css";
import { signal } from "@preact/signals-core";
import { html, nothing, type TemplateResult } from "lit-html";
import { reasonOf } from "../../net/reason";
import type { Span } from "../../state/timelineWindow";
import { draw } from "../../ui/draw";
import type { App } from "../../view/app";
import { filmStrip } from "../../view/filmStrip";
import { savePicture } from "../../view/pictures";
import { spanComparison } from "./spanComparison";

/** The longest recording that the server makes, ticks. */
const MOST_RECORDED = 3600;

/** Returns a span in words: `2.31 s to 4.50 s, 132 ticks`. */
export function spanWords({ from, to }: Span, rate: number): string {
  const [begin, end] = [from, to].map((tick) => (tick / rate).toFixed(2));
  return `${begin} s to ${end} s, ${to - from + 1} ticks`;
}

/** Returns the address of a span as an animated file. */
export const recordingUrl = (stage: string, { from, to }: Span): string =>
  `api/stages/${encodeURIComponent(stage)}/recording.glb?from=${from}&to=${to}`;

export function spanBar(host: HTMLElement, app: App): void {
  const { timeline, playback, stage, scene, notices, commands } = app;
  const isFilming = signal(false);
  const comparison = spanComparison(app);

  async function film(span: Span): Promise<void> {
    isFilming.value = true;
    try {
      const picture = await filmStrip(app, span, scene.look.value.transparent);
      savePicture(picture, `statwalk-${span.from}-${span.to}.png`);
    } catch (error) {
      notices.emit(reasonOf(error));
    } finally {
      isFilming.value = false;
    }
  }

  /** Does something with the selected span, or says how to select one. */
  const withSpan = (act: (span: Span) => void) => (): void => {
    if (timeline.selected.value) act(timeline.selected.value);
    else notices.emit("Select a span first: drag over the timeline with shift, or press I and K.");
  };
  const click = (what: string) => withSpan(() => host.querySelector<HTMLElement>(what)?.click());
  commands.add(
    { keys: [], words: "timeline: film strip of the span", act: withSpan((span) => void film(span)) },
    { keys: [], words: "timeline: save the span as recording.glb", act: click("a[download]") },
    { keys: [], words: "timeline: compare the span with another", act: click("[popovertarget]") },
    { keys: [], words: "timeline: show the span alone", act: withSpan((span) => timeline.show(span)) },
    { keys: [], words: "timeline: select nothing", act: () => timeline.select(0, 0) },
  );

  draw(host, () => {
    const span = timeline.selected.value;
    const { loop } = playback;
    host.hidden = span === null;
    if (!span) return html``;
    return html`<span class="span-words" role="status" .textContent=${spanWords(span, stage.rate)}></span>
      <button
        type="button"
        aria-pressed=${loop.value !== null}
        title="replay it again and again, on this page only (U)"
        @click=${() => timeline.loop()}
      >
        loop
      </button>
      ${saveLink(stage.id, span)}
      <button
        type="button"
        title="eight moments of the span side by side, as a PNG file"
        ?disabled=${isFilming.value}
        @click=${() => void film(span)}
      >
        film strip
      </button>
      ${comparison}
      <button type="button" title="show this span alone" @click=${() => timeline.show(span)}>zoom</button>
      <button
        type="button"
        class="plain square"
        aria-label="select nothing"
        @click=${() => timeline.select(0, 0)}
      >
        ×
      </button>`;
  });
}

function saveLink(stage: string, span: Span): TemplateResult | typeof nothing {
  if (span.to - span.from >= MOST_RECORDED)
    return html`<span title="a recording has at most ${MOST_RECORDED} ticks">too long to save</span>`;
  return html`<a
    download="recording.glb"
    href=${recordingUrl(stage, span)}
    title="the span as one animated file"
    >save recording.glb</a
  >`;
}
