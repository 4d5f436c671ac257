import { expect, test } from "vitest";
import { MOST_PLACES, MotionPath } from "./motionPath";

test("the path keeps the latest places in order", () => {
  const path = new MotionPath();
  for (let tick = 0; tick < MOST_PLACES + 3; tick++) path.add("hand", tick, [tick, 0, 1]);
  expect(path.points).toHaveLength(MOST_PLACES);
  expect([path.points[0], path.points.at(-1)]).toEqual([
    [3, 0, 1],
    [MOST_PLACES + 2, 0, 1],
  ]);
});

test("another joint begins a new path", () => {
  const path = new MotionPath();
  path.add("hand", 1, [0, 0, 0]);
  path.add("foot", 2, [1, 0, 0]);
  expect(path.points).toEqual([[1, 0, 0]]);
  path.add("foot", 200, [2, 0, 0]);
  path.add("foot", 200, [3, 0, 0]);
  expect(path.points).toEqual([[2, 0, 0]]);
  path.clear();
  expect(path.points).toEqual([]);
});
