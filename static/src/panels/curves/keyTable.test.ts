import { expect, test } from "vitest";
import { EXAMPLES, fault, type Key } from "./keyTable";

const keys = EXAMPLES["a wave"]!;
const changed = (row: number, change: Partial<Key>): Key[] =>
  keys.map((key, at) => (at === row ? { ...key, ...change } : key));

test("the examples are sound", () => {
  for (const example of Object.values(EXAMPLES)) expect(fault(example)).toBe("");
});

test("a fault names its key and its number", () => {
  expect(fault(changed(1, { time: 0 }))).toBe("key 2: times should rise");
  expect(fault(changed(2, { y_deg: Number.NaN }))).toBe("key 3: y° should be -3600 to 3600");
  expect(fault(changed(0, { weight: 0 }))).toBe("key 1: weight should be 0.001 to 1000");
  expect(fault(keys.slice(0, 1))).toBe("two keys are needed");
});
