/** The pointer over the lanes: the wheel and two fingers zoom, a drag with shift or while `selecting` selects. */

import type { Signal } from "@preact/signals-core";
import { type Span, type TimelineWindow, zoomed } from "../../state/timelineWindow";

/** A turn of the wheel by so many pixels makes the shown part e times as long. */
const WHEEL = 600;
/** Two fingers on a trackpad arrive as small turns with ctrl. */
const PINCH = 120;

interface Pinch {
  span: Span;
  at: number;
  distance: number;
}

export class LaneGestures {
  private readonly fingers = new Map<number, number>();
  private pinch: Pinch | null = null;
  private begin: number | null = null;

  constructor(
    private readonly lanes: HTMLElement,
    private readonly scrub: HTMLElement,
    private readonly timeline: TimelineWindow,
    private readonly selecting: Signal<boolean>,
  ) {
    lanes.addEventListener("wheel", (turn) => this.turned(turn), { passive: false });
    scrub.addEventListener("pointerdown", (press) => this.down(press));
    scrub.addEventListener("pointermove", (move) => this.moved(move));
    for (const end of ["pointerup", "pointercancel"] as const)
      scrub.addEventListener(end, ({ pointerId }) => this.up(pointerId));
  }

  /** Whether the pointer selects or zooms, and does not scrub. */
  get busy(): boolean {
    return this.begin !== null || this.pinch !== null;
  }

  private tickAt(x: number): number {
    const { left, width } = this.lanes.getBoundingClientRect();
    const { from, to } = this.timeline.span;
    return Math.round(from + ((x - left) / Math.max(1, width)) * (to - from));
  }

  private turned(turn: WheelEvent): void {
    turn.preventDefault();
    const { deltaX, deltaY, shiftKey, ctrlKey, clientX } = turn;
    const sideways = shiftKey ? deltaX || deltaY : Math.abs(deltaX) > Math.abs(deltaY) ? deltaX : 0;
    if (sideways) this.timeline.pan(sideways / this.lanes.clientWidth);
    else this.timeline.zoom(Math.exp(deltaY / (ctrlKey ? PINCH : WHEEL)), this.tickAt(clientX));
  }

  private down({ pointerId, clientX, shiftKey, button }: PointerEvent): void {
    if (button !== 0) return;
    this.fingers.set(pointerId, clientX);
    const [one, other] = [...this.fingers.values()];
    if (one !== undefined && other !== undefined) {
      const distance = Math.max(1, Math.abs(one - other));
      this.pinch = { span: this.timeline.span, at: this.tickAt((one + other) / 2), distance };
      this.begin = null;
    } else if (shiftKey || this.selecting.value) this.begin = this.tickAt(clientX);
    if (this.busy) this.scrub.setPointerCapture(pointerId);
  }

  private moved({ pointerId, clientX }: PointerEvent): void {
    if (!this.fingers.has(pointerId)) return;
    this.fingers.set(pointerId, clientX);
    if (this.begin !== null) this.timeline.select(this.begin, this.tickAt(clientX));
    const [one, other] = [...this.fingers.values()];
    if (!this.pinch || one === undefined || other === undefined) return;
    const { span, at, distance } = this.pinch;
    const factor = distance / Math.max(1, Math.abs(one - other));
    this.timeline.show(zoomed(span, at, factor));
  }

  private up(pointerId: number): void {
    this.fingers.delete(pointerId);
    if (!this.fingers.size) this.begin = this.pinch = null;
  }
}
