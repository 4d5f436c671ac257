import { describe, expect, it } from "vitest";
import { placeStates, renamed } from "./places";
import { STATE_HEIGHT, overlap, rectOf, stateWidth } from "./shapes";

const KEPT = new Map([
  ["A", { x: 0, y: 0 }],
  ["B", { x: 300, y: 0 }],
]);
const ROOM = { width: 400, height: 200 };
const EDGES = [{ from: "B", to: "NEW", events: ["E"] }];

describe("placeStates", () => {
  const places = placeStates(["A", "NEW", "B"], EDGES, KEPT, ROOM);

  it("moves no state that stays", () =>
    expect([places.get("A"), places.get("B")]).toEqual([KEPT.get("A"), KEPT.get("B")]));

  it("puts a new state beside its neighbour, not over it", () => {
    const { x, y } = places.get("NEW")!;
    const boxes = (["NEW", "B"] as const).map((name) =>
      rectOf({ name, ...places.get(name)!, width: stateWidth(name) }),
    );
    expect(Math.hypot(x - 300, y)).toBeLessThan(90);
    expect(overlap(boxes[0]!, boxes[1]!)).toBe(false);
  });

  it("leaves room for the label between a new state and its neighbour", () => {
    const { x, y } = places.get("NEW")!;
    const gaps = [Math.abs(x - 300) - (stateWidth("NEW") + stateWidth("B")) / 2, Math.abs(y) - STATE_HEIGHT];
    expect(Math.max(...gaps)).toBeGreaterThanOrEqual(24);
  });

  it("lays out a machine without kept places", () =>
    expect(placeStates(["A", "B"], [], new Map(), ROOM).size).toBe(2));
});

describe("renamed", () => {
  it("gives the place to the new name", () =>
    expect(renamed(KEPT, ["A", "B"], ["A", "RUN"]).get("RUN")).toEqual({ x: 300, y: 0 }));
  it("knows an added state from a renamed one", () =>
    expect(renamed(KEPT, ["A", "B"], ["A", "RUN", "B"])).toBe(KEPT));
});
