import { expect, test } from "vitest";
import { rounded, sides } from "./expressions";

test("a line has a name and a formula", () => {
  expect(sides("a.rotate_z = if(x == 1, 2, 3)")).toEqual(["a.rotate_z", "if(x == 1, 2, 3)"]);
});

test("values have at most four digits after the point", () => {
  expect(rounded(Math.PI)).toBe("3.1416");
  expect(rounded(8)).toBe("8");
});
