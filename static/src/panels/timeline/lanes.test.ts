import { describe, expect, it } from "vitest";
import { place, spanOf, stateColour, tickAt, upTo } from "./lanes";

describe("spanOf", () => {
  it.each([
    ["all of it", 0, 600, null, null, { from: 0, to: 600 }],
    ["the last of it", 0, 9000, 7200, null, { from: 1800, to: 9000 }],
    ["what one looks at is within", 0, 9000, 7200, 100, { from: 100, to: 9000 }],
    ["never nothing", 5, 5, null, null, { from: 5, to: 6 }],
  ])("%s", (_, first, head, window, looking, expected) =>
    expect(spanOf(first, head, window, looking)).toEqual(expected),
  );
});

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
