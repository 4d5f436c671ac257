/** The keys as diamonds on a line below the slider; you drag them to other times. */

import { el } from "../../ui/dom";
import type { Key } from "./keyTable";

const LATEST = 60;
const NEAREST = 0.01;
const STEP = 0.05;

/** Returns the time that a key may have: between its neighbours, in hundredths of a second. */
export function allowed(keys: readonly Key[], row: number, time: number): number {
  const low = row > 0 ? (keys[row - 1]?.time ?? 0) + NEAREST : 0;
  const high = row < keys.length - 1 ? (keys[row + 1]?.time ?? LATEST) - NEAREST : LATEST;
  return Number(Math.max(low, Math.min(high, time)).toFixed(2));
}

export class KeyStrip {
  private keys: readonly Key[] = [];
  private readonly line = el("div", { class: "line" });

  constructor(
    root: HTMLElement,
    private readonly moved: (row: number, time: number) => void,
  ) {
    root.append(this.line);
  }

  /** Takes the keys; while one is dragged, its diamond stays the same element. */
  show(keys: readonly Key[]): void {
    this.keys = keys;
    while (this.line.childElementCount > keys.length) this.line.lastElementChild?.remove();
    while (this.line.childElementCount < keys.length)
      this.line.append(this.diamond(this.line.childElementCount));
    const { first, span } = this.range();
    for (const [row, diamond] of [...this.line.children].entries()) {
      const time = keys[row]?.time ?? 0;
      (diamond as HTMLElement).style.left = `${(100 * (time - first)) / span}%`;
      diamond.setAttribute("aria-label", `key ${row + 1} at ${time} s`);
      diamond.setAttribute("title", `${time} s: drag, or use the arrow keys`);
    }
  }

  private range(): { first: number; span: number } {
    const first = this.keys[0]?.time ?? 0;
    return { first, span: Math.max(NEAREST, (this.keys.at(-1)?.time ?? 1) - first) };
  }

  private diamond(row: number): HTMLElement {
    const diamond = el("button", { type: "button", class: "diamond" });
    let drag: { x: number; time: number; perPixel: number } | null = null;
    diamond.addEventListener("pointerdown", (press) => {
      diamond.setPointerCapture(press.pointerId);
      const perPixel = this.range().span / Math.max(1, this.line.clientWidth);
      drag = { x: press.clientX, time: this.keys[row]?.time ?? 0, perPixel };
    });
    diamond.addEventListener("pointermove", (move) => {
      if (drag) this.move(row, drag.time + (move.clientX - drag.x) * drag.perPixel);
    });
    for (const end of ["pointerup", "pointercancel"] as const)
      diamond.addEventListener(end, () => (drag = null));
    diamond.addEventListener("keydown", (press) => {
      const way = press.key === "ArrowRight" ? STEP : press.key === "ArrowLeft" ? -STEP : 0;
      if (!way) return;
      press.preventDefault();
      this.move(row, (this.keys[row]?.time ?? 0) + way);
    });
    return diamond;
  }

  private move(row: number, time: number): void {
    const next = allowed(this.keys, row, time);
    if (next !== this.keys[row]?.time) this.moved(row, next);
  }
}
