import { describe, expect, it } from "vitest";
import { bars } from "./feet";

describe("bars", () => {
  it("are percentages", () => expect(bars([[0.25, 0.75]])).toEqual([[25, 50]]));

  it("go on at the left after the seam", () =>
    expect(bars([[0.5, 1.25]])).toEqual([
      [50, 50],
      [0, 25],
    ]));
});
