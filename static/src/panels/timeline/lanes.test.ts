import { describe, expect, it } from "vitest";
import { place, stateColour, tickAt, upTo } from "./lanes";

describe("place", () => {
  it("puts the ends at the ends", () => {
    const span = { from: 100, to: 300 };
    expect([place(100, span, 800), place(200, span, 800), place(300, span, 800)]).toEqual([0, 400, 800]);
  });
});

describe("tickAt", () => {
  const span = { from: 0, to: 1000 };

  it("is the tick that lies there", () => expect(tickAt(400, span, 1000, [], 7)).toBe(400));

  it("is what happened near it", () => expect(tickAt(400, span, 1000, [300, 396, 405], 7)).toBe(396));

  it("is never outside", () => expect(tickAt(-5, span, 1000, [], 7)).toBe(0));
});

describe("upTo", () => {
  it("draws out the newest alone", () => {
    const runs = [
      { start: 0, end: 4, state: "A" },
      { start: 5, end: 9, state: "B" },
    ];
    expect(upTo(runs, 20).map((run) => run.end)).toEqual([4, 20]);
  });
});

describe("stateColour", () => {
  it("gives neighbours different hues", () => {
    expect(new Set(Array.from({ length: 12 }, (_, i) => stateColour(i, true))).size).toBe(12);
  });
});
