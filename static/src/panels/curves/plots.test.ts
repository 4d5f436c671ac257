import { expect, test } from "vitest";
import { ceiling, valueAt } from "./plots";

test("the ceiling leaves room above, and cuts spikes off", () => {
  expect(ceiling([0, 10, 20], 1)).toBeCloseTo(23);
  expect(ceiling([...Array<number>(99).fill(1), 1000], 0.98)).toBeCloseTo(1.15);
  expect(ceiling([], 1)).toBe(1);
  expect(ceiling([0, 0], 1)).toBe(1);
});

test("a value between two samples is on the line between them", () => {
  expect(valueAt([0, 1, 2], [0, 10, 30], 1.5)).toBe(20);
  expect(valueAt([0, 1, 2], [0, 10, 30], 0)).toBe(0);
  expect(valueAt([0, 1, 2], [0, 10, 30], 2)).toBe(30);
  expect(valueAt([], [], 1)).toBe(0);
});
