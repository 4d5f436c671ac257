/** Finds places for the arrows' labels where they cover no box, no other label and, if possible, no other arrow. */

import {
  type Arrow,
  type Box,
  type Point,
  type Rect,
  around,
  overlap,
  pointAt,
  rectAt,
  rectOf,
} from "./shapes";

export interface Label extends Point {
  /** The events that are written out; `more` others are counted. */
  events: readonly string[];
  more: number;
}

type Spelling = Pick<Label, "events" | "more">;

/** The letters of labels: their height, and a function that gives the width of a text as a multiple of the height. */
export interface Letters {
  size: number;
  widthOf: (text: string) => number;
}

/** A point of an arrow. */
type Sample = Point & { arrow: Arrow };

/** Places along an arrow, the best first. */
const ALONG = [0.5, 0.42, 0.58, 0.34, 0.66, 0.26, 0.74, 0.18, 0.82];
const SAMPLES = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9];
/** Of the letters' size: the height of a line, and the space beside a text. */
const [LINE_HEIGHT, SPACE] = [1.2, 0.3];
const MOST_EVENTS = 3;

export function labelText({ events, more }: Spelling): string {
  return [events.join(", "), more ? `+${more}` : ""].filter(Boolean).join(" ");
}

/** Returns the ways to write an arrow's events, the longest first. */
function spellings(events: readonly string[]): Spelling[] {
  const counts = [Math.min(events.length, MOST_EVENTS), Math.min(events.length, 1)];
  return [...new Set(counts)].map((count) => ({
    events: events.slice(0, count),
    more: events.length - count,
  }));
}

/** Half the width and half the height of a label. */
function halfOf(spelling: Spelling, { size, widthOf }: Letters): Point {
  return { x: (widthOf(labelText(spelling)) / 2 + SPACE) * size, y: (LINE_HEIGHT * size) / 2 };
}

const meets = (rect: Rect, others: readonly Rect[]): boolean => others.some((other) => overlap(rect, other));

/**
 * Returns a label for each arrow, or null if the label finds no free place within `field`. Short labels are placed first:
 * they find a place most easily.
 */
export function placeLabels(
  arrows: readonly Arrow[],
  boxes: Iterable<Box>,
  letters: Letters,
  field: Rect,
): (Label | null)[] {
  const taken = [...boxes].map((box) => rectOf(box, 1));
  const lines = arrows.flatMap((arrow) => SAMPLES.map((t) => ({ arrow, ...pointAt(arrow.curve, t) })));
  const labels: (Label | null)[] = arrows.map(() => null);
  const order = arrows.map((_, index) => index).sort((a, b) => length(arrows[a]!) - length(arrows[b]!));
  for (const index of order) {
    const found = freePlace(arrows[index]!, taken, lines, letters, field);
    if (!found) continue;
    labels[index] = found;
    taken.push(rectAt(found, halfOf(found, letters)));
  }
  return labels;
}

const length = ({ events }: Arrow): number => events.join().length;

/**
 * Returns the first free place that no other arrow crosses, else the first free place; places on the arrow come before
 * places beside it.
 */
function freePlace(
  arrow: Arrow,
  taken: readonly Rect[],
  lines: readonly Sample[],
  letters: Letters,
  field: Rect,
): Label | null {
  for (const spelling of spellings(arrow.events)) {
    const half = halfOf(spelling, letters);
    const all = placesAt(arrow.curve, half);
    const reach = around(all.map((place) => rectAt(place, half)));
    const near = taken.filter((rect) => overlap(rect, reach));
    const strangers = lines.filter((point) => contains(reach, point) && point.arrow !== arrow);
    const places = all.filter((place) => {
      const rect = rectAt(place, half);
      return within(rect, field) && !meets(rect, near);
    });
    const clear = places.find((place) => !strangers.some((point) => contains(rectAt(place, half), point)));
    const place = clear ?? places[0];
    if (place) return { ...place, ...spelling };
  }
  return null;
}

const within = (rect: Rect, field: Rect): boolean =>
  rect.left >= field.left &&
  rect.right <= field.right &&
  rect.top >= field.top &&
  rect.bottom <= field.bottom;

const contains = ({ left, top, right, bottom }: Rect, { x, y }: Point): boolean =>
  x > left && x < right && y > top && y < bottom;

/** Returns the places for a label of this size: on the arrow, outside of its bend, and inside of it. */
function placesAt(curve: Arrow["curve"], half: Point): Point[] {
  const [start, , , end] = curve;
  const middle = pointAt(curve, 0.5);
  const bend = (end.x - start.x) * (middle.y - start.y) - (end.y - start.y) * (middle.x - start.x);
  const outside = bend < 0 ? -1 : 1;
  return [0, outside, -outside].flatMap((side) => ALONG.map((t) => aside(curve, t, half, side)));
}

/** Returns the middle of a label that touches the arrow from its right (`side` 1), its left (-1), or lies on it. */
function aside(curve: Arrow["curve"], t: number, half: Point, side: number): Point {
  const [at, before, after] = [pointAt(curve, t), pointAt(curve, t - 0.01), pointAt(curve, t + 0.01)];
  const [dx, dy] = [after.x - before.x, after.y - before.y];
  const long = Math.hypot(dx, dy) || 1;
  const by = (side * (Math.abs(dy) * half.x + Math.abs(dx) * half.y)) / (long * long);
  return { x: at.x - dy * by, y: at.y + dx * by };
}
