import { describe, expect, it } from "vitest";
import { firstFrom, moved } from "./gridMoves";

describe("moved", () => {
  it.each([
    ["ArrowDown", { row: 2, column: 1 }],
    ["ArrowLeft", { row: 1, column: 0 }],
    ["End", { row: 1, column: 4 }],
    ["x", null],
  ])("%s", (key, spot) => expect(moved({ row: 1, column: 1 }, key, 3, 5)).toEqual(spot));

  it("stays within", () =>
    expect(moved({ row: 2, column: 4 }, "ArrowDown", 3, 5)).toEqual({ row: 2, column: 4 }));
});

it("scrolls to the start of a column, never into one", () =>
  expect([40, 50, 51].map((least) => firstFrom([0, 50], least))).toEqual([50, 50, 51]));
