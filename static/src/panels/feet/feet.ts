/** Shows when each foot stands on the ground in the motion that plays: a bar for each foot, and the phase. */

import "./feet.css";
import { html, type TemplateResult } from "lit-html";
import { el } from "../../ui/dom";
import { draw } from "../../ui/draw";
import type { App } from "../../view/app";

type Span = readonly [number, number];

/** Splits spans that go on beyond phase 1 into parts within 0…1, as percentages: left edge and width. */
export function bars(spans: readonly (readonly number[])[]): Span[] {
  return spans.flatMap(([first = 0, last = 0]) => {
    const parts: Span[] = [[100 * first, 100 * (Math.min(last, 1) - first)]];
    return last > 1 ? [...parts, [0, 100 * (last - 1)] as const] : parts;
  });
}

const bar = ([left, width]: Span): TemplateResult =>
  html`<i .style=${`left: ${left}%; width: ${width}%`}></i>`;

export function feetPanel(host: HTMLElement, { contacts, frame, frames, machine, selection }: App): void {
  const box = el("div", { class: "feet", title: "when each foot stands on the ground" });
  const cursor = el("i", { class: "feet-cursor" });
  host.append(box);
  draw(box, () => {
    const state = machine.info.value?.states[selection.state.value ?? -1];
    const feet = (state && !state.over.length && contacts.of(state.motion)?.feet) || [];
    box.hidden = !feet.length;
    const rows = feet.map(
      ({ foot, planted }) =>
        html`<div class="feet-row">
          <span .textContent=${foot}></span>
          <div>${bars(planted).map(bar)}</div>
        </div>`,
    );
    return html`<div class="feet-rows">${rows}</div>
      ${cursor}`;
  });
  // The cursor is at the phase of the motion, 0…1.
  frame.on(() => {
    if (!box.hidden) cursor.style.setProperty("--phase", String(frames.phase() ?? 0));
  });
}
