import { expect, test } from "vitest";
import { allowed } from "./keyStrip";
import { EXAMPLES } from "./keyTable";

const keys = EXAMPLES["a wave"]!;

test("a key stays between its neighbours, in hundredths", () => {
  expect(allowed(keys, 1, 0.9999)).toBe(1);
  expect(allowed(keys, 1, 5)).toBe(1.19);
  expect(allowed(keys, 1, -5)).toBe(0.01);
});

test("the first key begins at 0 at the earliest, the last ends at 60 s at the latest", () => {
  expect(allowed(keys, 0, -1)).toBe(0);
  expect(allowed(keys, 4, 99)).toBe(60);
});
