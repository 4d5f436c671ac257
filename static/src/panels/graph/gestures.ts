/** Reads pointers over the graph: a drag of what is under them, of the background, or two fingers that zoom. */

import type { Camera } from "./camera";
import type { Point } from "./shapes";

/** A drag of something in the graph; places are in the graph's units. */
export interface Drag {
  move: (place: Point) => void;
  /** The pointer has been released over `target`. */
  end: (target: Element | null) => void;
  cancel: () => void;
}

/** Pixels that a pointer moves before a press becomes a drag. */
const SLOP = 4;
const WHEEL_SPEED = 0.0016;

export class Gestures {
  private readonly pointers = new Map<number, Point>();
  private drag: Drag | null = null;
  private pressedOn: Element | null = null;
  private start: Point = { x: 0, y: 0 };
  private moving = false;
  /** Whether the pointer's last press was a drag: the click that follows it means nothing. */
  dragged = false;

  constructor(
    private readonly canvas: SVGSVGElement,
    private readonly camera: Camera,
    /** Returns the drag that begins on an element, or null: then the background moves. */
    private readonly begin: (target: Element, place: Point) => Drag | null,
  ) {
    canvas.addEventListener("wheel", (wheel) => this.wheel(wheel), { passive: false });
    canvas.addEventListener("pointerdown", (press) => this.press(press));
    canvas.addEventListener("pointermove", (move) => this.move(move));
    canvas.addEventListener("pointerup", (release) => this.release(release, false));
    canvas.addEventListener("pointercancel", (release) => this.release(release, true));
  }

  /** Ends a drag without its effect. */
  cancel(): boolean {
    const drag = this.drag;
    this.drag = null;
    drag?.cancel();
    return drag !== null;
  }

  private wheel(wheel: WheelEvent): void {
    wheel.preventDefault();
    const lines = wheel.deltaMode === WheelEvent.DOM_DELTA_LINE ? 24 : 1;
    const pinch = wheel.ctrlKey ? 6 : 1;
    this.camera.zoomBy(Math.exp(-wheel.deltaY * lines * pinch * WHEEL_SPEED), placeOf(wheel));
  }

  private press(press: PointerEvent): void {
    if (press.button !== 0) return;
    this.pointers.set(press.pointerId, placeOf(press));
    this.start = placeOf(press);
    this.moving = this.dragged = false;
    this.pressedOn = press.target as Element;
    if (this.pointers.size > 1) {
      this.cancel();
      this.grab();
    }
  }

  /** Keeps getting the pointers' moves outside the canvas too. */
  private grab(): void {
    this.moving = this.dragged = true;
    for (const pointer of this.pointers.keys()) this.canvas.setPointerCapture(pointer);
  }

  private move(move: PointerEvent): void {
    const before = this.pointers.get(move.pointerId);
    if (!before) return;
    const now = placeOf(move);
    if (!this.moving) {
      if (Math.hypot(now.x - this.start.x, now.y - this.start.y) < SLOP) return;
      this.grab();
      this.drag = this.begin(this.pressedOn!, this.camera.toGraph(this.start));
    }
    this.pointers.set(move.pointerId, now);
    if (this.pointers.size > 1) this.pinch(move.pointerId, before, now);
    else if (this.drag) this.drag.move(this.camera.toGraph(now));
    else this.camera.pan(now.x - before.x, now.y - before.y);
  }

  /** Zooms and pans by one of two fingers. */
  private pinch(pointer: number, before: Point, now: Point): void {
    const still = [...this.pointers].find(([id]) => id !== pointer)![1];
    const apart = ({ x, y }: Point): number => Math.max(1, Math.hypot(x - still.x, y - still.y));
    this.camera.pan((now.x - before.x) / 2, (now.y - before.y) / 2);
    const middle = { x: (now.x + still.x) / 2, y: (now.y + still.y) / 2 };
    this.camera.zoomBy(apart(now) / apart(before), middle);
  }

  private release(release: PointerEvent, cancelled: boolean): void {
    this.pointers.delete(release.pointerId);
    const drag = this.drag;
    this.drag = null;
    if (cancelled) drag?.cancel();
    else drag?.end(document.elementFromPoint(release.clientX, release.clientY));
  }
}

const placeOf = ({ clientX, clientY }: MouseEvent): Point => ({ x: clientX, y: clientY });
