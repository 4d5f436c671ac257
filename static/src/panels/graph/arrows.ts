/** Leads arrows from box to box, around the boxes between them. */

import type { Edge } from "../../net/protocol";
import { type Arrow, type Box, type Point, type Rect, borderPoint, overlap, pointAt, rectOf } from "./shapes";

/** How far the middle of an arrow may stand aside of the straight line; the first that meets no box is taken. */
const BENDS = [0, 22, -22, 44, -44, 76, -76, 120, -120];
/** Two arrows between the same states stand this far aside, each to its own left. */
const PAIR_BEND = 12;
const SAMPLES = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9];
/** Straight lines that no pointer can tell from a curve. */
const LINES = 24;
/** Space between an arrow and a box that it passes. */
const CLEARANCE = 4;

export const direction = (from: string, to: string): string => JSON.stringify([from, to]);

/** Returns the arrows of `edges`; an edge of a state that has no box is left out. */
export function leadArrows(edges: readonly Edge[], boxes: ReadonlyMap<string, Box>): Arrow[] {
  const directions = new Set(edges.map(({ from, to }) => direction(from, to)));
  const obstacles = [...boxes.values()].map((box) => ({ name: box.name, rect: rectOf(box, CLEARANCE) }));
  return edges.flatMap((edge) => {
    const [from, to] = [boxes.get(edge.from), boxes.get(edge.to)];
    if (!from || !to) return [];
    if (from === to) return [{ ...edge, curve: loop(from) }];
    const bend = directions.has(direction(edge.to, edge.from)) ? PAIR_BEND : 0;
    const others = obstacles.filter(({ name }) => name !== edge.from && name !== edge.to);
    return [{ ...edge, curve: freest(from, to, bend, nearby(from, to, others)) }];
  });
}

function nearby(from: Box, to: Box, obstacles: readonly { rect: Rect }[]): Rect[] {
  const reach = Math.max(...BENDS) + PAIR_BEND;
  const field: Rect = {
    left: Math.min(from.x, to.x) - reach,
    top: Math.min(from.y, to.y) - reach,
    right: Math.max(from.x, to.x) + reach,
    bottom: Math.max(from.y, to.y) + reach,
  };
  return obstacles.map(({ rect }) => rect).filter((rect) => overlap(rect, field));
}

function freest(from: Box, to: Box, bend: number, obstacles: readonly Rect[]): Arrow["curve"] {
  let best: { curve: Arrow["curve"]; hits: number } | null = null;
  for (const more of BENDS) {
    const curve = bent(from, to, bend + more);
    const hits = SAMPLES.filter((t) => covered(pointAt(curve, t), obstacles)).length;
    if (!best || hits < best.hits) best = { curve, hits };
    if (!best.hits) break;
  }
  return best!.curve;
}

function covered({ x, y }: Point, rects: readonly Rect[]): boolean {
  return rects.some(({ left, top, right, bottom }) => x > left && x < right && y > top && y < bottom);
}

/** Draws a curve whose middle stands `bend` to the left of the straight line. */
function bent(from: Box, to: Box, bend: number): Arrow["curve"] {
  const [dx, dy] = [to.x - from.x, to.y - from.y];
  const length = Math.hypot(dx, dy) || 1;
  const aside = { x: (dy / length) * bend * 2, y: (-dx / length) * bend * 2 };
  const control = { x: (from.x + to.x) / 2 + aside.x, y: (from.y + to.y) / 2 + aside.y };
  const [start, end] = [borderPoint(from, control), borderPoint(to, control)];
  const towards = (point: Point): Point => ({
    x: point.x + ((control.x - point.x) * 2) / 3,
    y: point.y + ((control.y - point.y) * 2) / 3,
  });
  return [start, towards(start), towards(end), end];
}

/** Draws an arrow from a state to itself: a loop at its upper right corner. */
function loop(box: Box): Arrow["curve"] {
  const { right, top } = rectOf(box);
  return [
    { x: right - 18, y: top },
    { x: right - 20, y: top - 22 },
    { x: right + 22, y: top - 18 },
    { x: right, y: top + 10 },
  ];
}

/** Returns the arrow that passes nearest to a place; null if there is none. */
export function nearest(arrows: readonly Arrow[], place: Point): Arrow | null {
  const by = arrows.map((arrow) => [distance(arrow.curve, place), arrow] as const);
  return by.reduce<(typeof by)[0] | null>((a, b) => (a && a[0] <= b[0] ? a : b), null)?.[1] ?? null;
}

/** Returns the distance of a place from a curve, which is drawn as short lines. */
function distance(curve: Arrow["curve"], place: Point): number {
  const points = Array.from({ length: LINES + 1 }, (_, i) => pointAt(curve, i / LINES));
  return Math.min(...points.slice(1).map((end, i) => fromLine(points[i]!, end, place)));
}

function fromLine(start: Point, end: Point, { x, y }: Point): number {
  const [dx, dy] = [end.x - start.x, end.y - start.y];
  const part = ((x - start.x) * dx + (y - start.y) * dy) / Math.max(dx ** 2 + dy ** 2, 1e-9);
  const t = Math.min(1, Math.max(0, part));
  return Math.hypot(start.x + t * dx - x, start.y + t * dy - y);
}
