/** Shows when each foot stands on the ground in the motion that plays: a bar for each foot, and the phase. */

import "./feet.css";
import type { App } from "../../view/app";
import { el } from "../../ui/dom";

type Span = readonly [number, number];

/** Splits spans that go on beyond phase 1 into parts within 0…1, as percentages: left edge and width. */
export function bars(spans: readonly (readonly number[])[]): Span[] {
  return spans.flatMap(([first = 0, last = 0]) => {
    const parts: Span[] = [[100 * first, 100 * (Math.min(last, 1) - first)]];
    return last > 1 ? [...parts, [0, 100 * (last - 1)] as const] : parts;
  });
}

class FeetStrip {
  private readonly rows = el("div", { class: "feet-rows" });
  private readonly cursor = el("i", { class: "feet-cursor" });
  private readonly box = el("div", { class: "feet", title: "when each foot stands on the ground" });

  constructor(
    host: HTMLElement,
    private readonly app: App,
  ) {
    this.box.hidden = true;
    this.box.append(this.rows, this.cursor);
    host.append(this.box);
    app.contacts.view.subscribe(() => this.show());
    app.selection.state.subscribe(() => this.show());
    app.frame.on(() => this.point(app.frames.phase()));
  }

  private show(): void {
    const state = this.app.machine.info.value?.states[this.app.selection.state.value ?? -1];
    const clip = state && !state.over.length ? this.app.contacts.of(state.motion) : null;
    this.box.hidden = !clip?.feet.length;
    const rows = (clip?.feet ?? []).map(({ foot, planted }) =>
      el(
        "div",
        { class: "feet-row" },
        el("span", {}, foot),
        el("div", {}, ...bars(planted).map(([left, width]) => bar(left, width))),
      ),
    );
    this.rows.replaceChildren(...rows);
  }

  /** Moves the cursor to the phase of the motion, 0…1. */
  private point(phase: number | null): void {
    if (!this.box.hidden) this.cursor.style.setProperty("--phase", String(phase ?? 0));
  }
}

function bar(left: number, width: number): HTMLElement {
  const mark = el("i", {});
  mark.style.left = `${left}%`;
  mark.style.width = `${width}%`;
  return mark;
}

export function feetPanel(host: HTMLElement, app: App): void {
  new FeetStrip(host, app);
}
