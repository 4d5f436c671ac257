import { describe, expect, it } from "vitest";
import { leadArrows } from "./arrows";
import { labelText, placeLabels } from "./labels";
import { type Arrow, type Box, around, overlap, rectAt, rectOf } from "./shapes";

const LETTERS = { size: 11, widthOf: (text: string) => 0.62 * text.length };
const FIELD = { left: -500, top: -500, right: 900, bottom: 900 };
const NAMES = ["STAT", "WALK", "JUMP", "LAND", "TLFT", "TRGT", "FALL", "REST"];
const BOXES = new Map<string, Box>(
  NAMES.map((name, i) => [name, { name, x: (i % 4) * 110, y: Math.floor(i / 4) * 90, width: 50 }]),
);
const EDGES = NAMES.flatMap((from, i) =>
  [1, 3].map((by) => ({ from, to: NAMES[(i + by) % 8]!, events: ["FORWARD", "BACK", "STOP", "FASTER"] })),
);

/** The rectangles of the letters of labels that have a place. */
const written = (arrows: readonly Arrow[], boxes: ReadonlyMap<string, Box>, field = FIELD) =>
  placeLabels(arrows, boxes.values(), LETTERS, field)
    .flatMap((label) => label ?? [])
    .map((label) => rectAt(label, { x: (LETTERS.widthOf(labelText(label)) * LETTERS.size) / 2, y: 5 }));

describe("the labels of sixteen arrows", () => {
  const rects = written(leadArrows(EDGES, BOXES), BOXES);

  it("find a place, at least half of them", () => expect(rects.length).toBeGreaterThan(7));
  it("cover no other label", () =>
    expect(rects.filter((a, i) => rects.slice(i + 1).some((b) => overlap(a, b)))).toEqual([]));
  it("cover no state", () => {
    const states = [...BOXES.values()].map((box) => rectOf(box));
    expect(rects.filter((rect) => states.some((state) => overlap(rect, state)))).toEqual([]);
  });
});

const pair = (name: string, x: number, y: number): [string, Box] => [name, { name, x, y, width: 44 }];

describe("the labels of two opposite arrows between states with room for one line", () => {
  const boxes = new Map([pair("HANG", 0, 0), pair("MOORED", 0, 52)]);
  const arrows = leadArrows(
    [
      { from: "HANG", to: "MOORED", events: ["MOOR"] },
      { from: "MOORED", to: "HANG", events: ["WEIGH"] },
    ],
    boxes,
  );

  it("stand beside the arrows", () => {
    const [moor, weigh] = written(arrows, boxes);
    expect(overlap(moor!, weigh!)).toBe(false);
  });

  it("are left out rather than outside of the field", () => {
    const narrow = around([...boxes.values()].map((box) => rectOf(box)));
    expect(written(arrows, boxes, narrow)).toHaveLength(1);
  });
});

it("a label is shortened where it has no room, and left out where it has none at all", () => {
  const near = new Map([pair("A", 0, 0), pair("B", 110, 0)]);
  const field = around([...near.values()].map((box) => rectOf(box)));
  const text = (events: string[]) => {
    const [label] = placeLabels(
      leadArrows([{ from: "A", to: "B", events }], near),
      near.values(),
      LETTERS,
      field,
    );
    return label ? labelText(label) : null;
  };
  expect([text(["GO"]), text(["GO", "FORWARD", "BACKWARD"]), text(["X".repeat(40)])]).toEqual([
    "GO",
    "GO +2",
    null,
  ]);
});
