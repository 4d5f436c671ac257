import { expect, test } from "vitest";
import { changeOf } from "./changeOf";

test.each([
  ["WALK | STAT", "WALK | STWK", { from: 9, to: 11, insert: "WK" }],
  ["aa", "aaa", { from: 2, to: 2, insert: "a" }],
  ["aaa", "a", { from: 1, to: 3, insert: "" }],
  ["", "x", { from: 0, to: 0, insert: "x" }],
])("%s becomes %s by one replacement", (before, after, change) => {
  const found = changeOf(before, after)!;
  expect(found).toEqual(change);
  expect(before.slice(0, found.from) + found.insert + before.slice(found.to)).toBe(after);
});

test("the same text needs no change", () => expect(changeOf("a", "a")).toBeNull());
