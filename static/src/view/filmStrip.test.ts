import { expect, it } from "vitest";
import { momentsOf } from "./filmStrip";

it("takes the first and the last moment, and the others evenly between", () => {
  expect(momentsOf({ from: 100, to: 170 })).toEqual([100, 110, 120, 130, 140, 150, 160, 170]);
  expect(momentsOf({ from: 100, to: 102 })).toEqual([100, 101, 102]);
});
