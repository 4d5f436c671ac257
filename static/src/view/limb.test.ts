import { expect, test } from "vitest";
import { limbOf } from "./limb";

//          0 hips
//    1 spine    5 leg
//  2 arm  4 head  6 foot
//  3 hand
const PARENTS = [-1, 0, 1, 2, 1, 0, 5];
const ALL = new Set(PARENTS.keys());

test("a limb begins below the joint from which several bones go out", () => {
  expect(limbOf(3, PARENTS, ALL)).toEqual([2, 3]);
  expect(limbOf(6, PARENTS, ALL)).toEqual([5, 6]);
  expect(limbOf(4, PARENTS, ALL)).toEqual([4]);
});

test("a chain without branches is a limb from its root, and joints that are no bones do not count", () => {
  expect(limbOf(3, [-1, 0, 1, 2], new Set([0, 1, 2, 3]))).toEqual([0, 1, 2, 3]);
  expect(limbOf(3, PARENTS, new Set([0, 1, 2, 3, 5, 6]))).toEqual([1, 2, 3]);
});
