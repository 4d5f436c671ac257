/** What part of the graph is seen, and how large: pans, zooms, fits. */

import { Event } from "../../state/event";
import type { Point, Rect } from "./shapes";

const [LEAST_ZOOM, MOST_ZOOM] = [0.08, 3];
/** Pixels around the fitted drawing. */
const MARGIN = 8;

export class Camera {
  /** Emitted with the new zoom after each change. */
  readonly changed = new Event<number>();
  zoom = 1;
  /** Whether the whole drawing is in sight because it was fitted, and nothing was moved since. */
  fitted = true;
  /** Where the graph's origin stands on the canvas, pixels. */
  private origin: Point = { x: 0, y: 0 };

  constructor(
    private readonly canvas: SVGSVGElement,
    private readonly world: SVGGElement,
  ) {}

  /** Returns the place in the graph of a place in the window. */
  toGraph({ x, y }: Point): Point {
    const { left, top } = this.canvas.getBoundingClientRect();
    return { x: (x - left - this.origin.x) / this.zoom, y: (y - top - this.origin.y) / this.zoom };
  }

  /** Returns the place in the window of a place in the graph. */
  toWindow({ x, y }: Point): Point {
    const { left, top } = this.canvas.getBoundingClientRect();
    return { x: left + this.origin.x + x * this.zoom, y: top + this.origin.y + y * this.zoom };
  }

  pan(dx: number, dy: number): void {
    this.fitted = false;
    this.apply({ x: this.origin.x + dx, y: this.origin.y + dy }, this.zoom);
  }

  /** Zooms; `at`, a place in the window, stays where it is: without it, the middle. */
  zoomBy(factor: number, at: Point = this.middle): void {
    const zoom = Math.min(MOST_ZOOM, Math.max(LEAST_ZOOM, this.zoom * factor));
    const { left, top } = this.canvas.getBoundingClientRect();
    const { x, y } = this.toGraph(at);
    this.fitted = false;
    this.apply({ x: at.x - left - x * zoom, y: at.y - top - y * zoom }, zoom);
  }

  /** Brings all of `bounds` into sight, not enlarged. */
  fit({ left, top, right, bottom }: Rect): void {
    const { width, height } = this.size;
    if (!width || !height) return;
    const wide = (width - 2 * MARGIN) / Math.max(1, right - left);
    const high = (height - 2 * MARGIN) / Math.max(1, bottom - top);
    const zoom = Math.max(LEAST_ZOOM, Math.min(1, wide, high));
    this.fitted = true;
    this.look({ x: (left + right) / 2, y: (top + bottom) / 2 }, zoom);
  }

  /** Brings `rect` into sight, with as little movement as possible. */
  reveal({ left, top, right, bottom }: Rect): void {
    const { width, height } = this.size;
    const into = (low: number, high: number, size: number): number =>
      low < MARGIN ? MARGIN - low : Math.min(0, size - MARGIN - high);
    const { zoom, origin } = this;
    const dx = into(left * zoom + origin.x, right * zoom + origin.x, width);
    const dy = into(top * zoom + origin.y, bottom * zoom + origin.y, height);
    if (dx || dy) this.pan(dx, dy);
  }

  private get size(): DOMRect {
    return this.canvas.getBoundingClientRect();
  }

  private get middle(): Point {
    const { left, top, width, height } = this.size;
    return { x: left + width / 2, y: top + height / 2 };
  }

  private look({ x, y }: Point, zoom: number): void {
    const { width, height } = this.size;
    this.apply({ x: width / 2 - x * zoom, y: height / 2 - y * zoom }, zoom);
  }

  private apply(origin: Point, zoom: number): void {
    this.origin = origin;
    this.zoom = zoom;
    this.world.setAttribute(
      "transform",
      `translate(${origin.x.toFixed(2)} ${origin.y.toFixed(2)}) scale(${zoom.toFixed(4)})`,
    );
    this.changed.emit(zoom);
  }
}
