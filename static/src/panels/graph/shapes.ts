/** The boxes and arrows of the state graph, in its own units: a pixel at zoom 1. */

import type { Edge } from "../../net/protocol";

export type Point = { x: number; y: number };

export interface Size {
  width: number;
  height: number;
}

/** Where each state stands. */
export type Places = Map<string, Point>;

/** Places, and how much room states need that stand there. */
export interface Plan extends Size {
  places: Places;
}

/** A state's box; x and y are its middle. */
export interface Box extends Point {
  name: string;
  width: number;
}

/** A rectangle by its sides. */
export interface Rect {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

/** An edge with the cubic curve that draws it: start, two control points, end. */
export interface Arrow extends Edge {
  curve: readonly [Point, Point, Point, Point];
}

export const STATE_HEIGHT = 28;
const CHARACTER_WIDTH = 7.8;
const LONGEST_NAME = 19;

export function shortName(name: string): string {
  return name.length > LONGEST_NAME ? `${name.slice(0, LONGEST_NAME - 1)}…` : name;
}

export function stateWidth(name: string): number {
  return Math.max(44, shortName(name).length * CHARACTER_WIDTH + 18);
}

/** Returns the rectangle around a middle; `half`: half its width and half its height. */
export const rectAt = ({ x, y }: Point, half: Point): Rect => ({
  left: x - half.x,
  top: y - half.y,
  right: x + half.x,
  bottom: y + half.y,
});

export function rectOf(box: Box, margin = 0): Rect {
  return rectAt(box, { x: box.width / 2 + margin, y: STATE_HEIGHT / 2 + margin });
}

export function overlap(a: Rect, b: Rect): boolean {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

/** Returns the smallest rectangle around all of `rects`. */
export function around(rects: readonly Rect[]): Rect {
  return {
    left: Math.min(...rects.map(({ left }) => left)),
    top: Math.min(...rects.map(({ top }) => top)),
    right: Math.max(...rects.map(({ right }) => right)),
    bottom: Math.max(...rects.map(({ bottom }) => bottom)),
  };
}

/** Returns the point at which the line from a box's middle to `to` leaves the box. */
export function borderPoint({ x, y, width }: Box, to: Point): Point {
  const [dx, dy] = [to.x - x, to.y - y];
  const out = Math.min(
    width / 2 / Math.max(Math.abs(dx), 1e-6),
    STATE_HEIGHT / 2 / Math.max(Math.abs(dy), 1e-6),
    1,
  );
  return { x: x + dx * out, y: y + dy * out };
}

/** Returns the point of a cubic curve at `t`, 0 … 1. */
export function pointAt([a, b, c, d]: Arrow["curve"], t: number): Point {
  const s = 1 - t;
  const [wa, wb, wc, wd] = [s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t];
  return { x: wa * a.x + wb * b.x + wc * c.x + wd * d.x, y: wa * a.y + wb * b.y + wc * c.y + wd * d.y };
}

/** Writes a curve as an SVG path. */
export function svgPath([start, ...rest]: Arrow["curve"]): string {
  const at = ({ x, y }: Point): string => `${x.toFixed(1)} ${y.toFixed(1)}`;
  return `M${at(start)}C${rest.map(at).join(" ")}`;
}
