import { expect, test } from "vitest";
import { newMarker, phase } from "./markerTexts";

test("a phase is a number from 0 to 1; blank takes the marker away", () => {
  expect(["0", "0.25", " "].map(phase)).toEqual([0, 0.25, null]);
  expect(() => phase("1.5")).toThrow("a phase from 0 to 1");
});

test("a new marker has a name and a phase", () => {
  expect(newMarker(" left-down  0.25 ")).toEqual({ name: "left-down", at: 0.25 });
  expect(() => newMarker("left-down")).toThrow("as in: left-down 0.25");
  expect(() => newMarker("left-down 2")).toThrow("from 0 to 1");
});
