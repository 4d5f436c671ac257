/** Finds places for the arrows' labels where they cover no box, no other label and, if possible, no other arrow. */

import { type Arrow, type Box, type Point, type Rect, overlap, pointAt, rectOf } from "./shapes";

export interface Label extends Point {
  /** The events that are written out; `more` others are counted. */
  events: readonly string[];
  more: number;
}

/** Places along an arrow, the best first. */
const ALONG = [0.5, 0.42, 0.58, 0.34, 0.66, 0.26, 0.74, 0.18, 0.82];
const SAMPLES = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9];
/** Of the letters' size. */
const [LETTER_WIDTH, LINE_HEIGHT] = [0.62, 1.2];
const MOST_EVENTS = 3;

export function labelText({ events, more }: Pick<Label, "events" | "more">): string {
  return [events.join(", "), more ? `+${more}` : ""].filter(Boolean).join(" ");
}

/** Returns the ways to write an arrow's events, the longest first. */
function spellings(events: readonly string[]): Pick<Label, "events" | "more">[] {
  const counts = [Math.min(events.length, MOST_EVENTS), Math.min(events.length, 1)];
  return [...new Set(counts)].map((count) => ({
    events: events.slice(0, count),
    more: events.length - count,
  }));
}

function rectAt({ x, y }: Point, text: string, size: number): Rect {
  const [w, h] = [(text.length * LETTER_WIDTH * size) / 2, (LINE_HEIGHT * size) / 2];
  return { left: x - w, top: y - h, right: x + w, bottom: y + h };
}

const meets = (rect: Rect, others: readonly Rect[]): boolean => others.some((other) => overlap(rect, other));

/**
 * Returns a label for each arrow, or null if there is no free place; `size` is the height of the letters. Short
 * labels come first: they find a place most easily.
 */
export function placeLabels(arrows: readonly Arrow[], boxes: Iterable<Box>, size: number): (Label | null)[] {
  const taken = [...boxes].map((box) => rectOf(box, 1));
  const lines = arrows.flatMap((arrow, index) =>
    SAMPLES.map((t) => ({ index, point: pointAt(arrow.curve, t) })),
  );
  const labels: (Label | null)[] = arrows.map(() => null);
  const order = arrows.map((_, index) => index).sort((a, b) => length(arrows[a]!) - length(arrows[b]!));
  for (const index of order) {
    const strangers = lines.filter((line) => line.index !== index).map(({ point }) => point);
    const found = freePlace(arrows[index]!, taken, strangers, size);
    if (!found) continue;
    labels[index] = found;
    taken.push(rectAt(found, labelText(found), size));
  }
  return labels;
}

const length = ({ events }: Arrow): number => events.join().length;

function freePlace(
  arrow: Arrow,
  taken: readonly Rect[],
  lines: readonly Point[],
  size: number,
): Label | null {
  for (const spelling of spellings(arrow.events)) {
    const text = labelText(spelling);
    const places = ALONG.map((t) => pointAt(arrow.curve, t)).filter(
      (place) => !meets(rectAt(place, text, size), taken),
    );
    const clear = places.find((place) => !crossed(rectAt(place, text, size), lines));
    const place = clear ?? places[0];
    if (place) return { ...place, ...spelling };
  }
  return null;
}

function crossed({ left, top, right, bottom }: Rect, lines: readonly Point[]): boolean {
  return lines.some(({ x, y }) => x > left && x < right && y > top && y < bottom);
}
