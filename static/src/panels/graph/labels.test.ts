import { describe, expect, it } from "vitest";
import { leadArrows } from "./arrows";
import { labelText, placeLabels } from "./labels";
import { type Box, overlap, rectOf } from "./shapes";

const SIZE = 11;
const NAMES = ["STAT", "WALK", "JUMP", "LAND", "TLFT", "TRGT", "FALL", "REST"];
const BOXES = new Map<string, Box>(
  NAMES.map((name, i) => [name, { name, x: (i % 4) * 110, y: Math.floor(i / 4) * 90, width: 50 }]),
);
const EDGES = NAMES.flatMap((from, i) =>
  [1, 3].map((by) => ({ from, to: NAMES[(i + by) % 8]!, events: ["FORWARD", "BACK", "STOP", "FASTER"] })),
);
const arrows = leadArrows(EDGES, BOXES);

describe("the labels of sixteen arrows", () => {
  const labels = placeLabels(arrows, BOXES.values(), SIZE).flatMap((label) => label ?? []);
  const rects = labels.map((label) => {
    const [w, h] = [(labelText(label).length * 0.55 * SIZE) / 2, SIZE / 2];
    return { left: label.x - w, right: label.x + w, top: label.y - h, bottom: label.y + h };
  });

  it("find a place, more than half of them", () => expect(labels.length).toBeGreaterThan(7));
  it("cover no other label", () =>
    expect(rects.filter((a, i) => rects.slice(i + 1).some((b) => overlap(a, b)))).toEqual([]));
  it("cover no state", () => {
    const states = [...BOXES.values()].map((box) => rectOf(box));
    expect(rects.filter((rect) => states.some((state) => overlap(rect, state)))).toEqual([]);
  });
});

it("a label is shortened where it has no room, and left out where it has none at all", () => {
  const near = new Map<string, Box>([
    ["A", { name: "A", x: 0, y: 0, width: 44 }],
    ["B", { name: "B", x: 110, y: 0, width: 44 }],
  ]);
  const written = (events: string[]) => {
    const [label] = placeLabels(leadArrows([{ from: "A", to: "B", events }], near), near.values(), SIZE);
    return label ? labelText(label) : null;
  };
  expect([written(["GO"]), written(["GO", "FORWARD", "BACKWARD"]), written(["X".repeat(40)])]).toEqual([
    "GO",
    "GO +2",
    null,
  ]);
});
