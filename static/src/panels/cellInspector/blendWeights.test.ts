import { expect, test } from "vitest";
import { weightsAt, wholePercent } from "./blendWeights";

const LINE = { walk: [1], run: [3], stand: [0] };
const PLANE = { stand: [0, 0], walk: [0, 1], left: [-1, 0], right: [1, 0] };

test.each([
  { points: LINE, at: [2], weights: { walk: 0.5, run: 0.5, stand: 0 } },
  { points: LINE, at: [0.25], weights: { walk: 0.25, run: 0, stand: 0.75 } },
  { points: LINE, at: [3], weights: { walk: 0, run: 1, stand: 0 } },
  { points: LINE, at: [9], weights: { walk: 0, run: 1, stand: 0 } },
  { points: PLANE, at: [0, 1], weights: { stand: 0, walk: 1, left: 0, right: 0 } },
  { points: PLANE, at: [0, 0.25], weights: { stand: 0.75, walk: 0.25, left: 0, right: 0 } },
  { points: PLANE, at: [0.5, 0.5], weights: { stand: 1 / 3, walk: 1 / 3, left: 0, right: 1 / 3 } },
])("at $at the clips have $weights", ({ points, at, weights }) => {
  const found = weightsAt(points, at);
  for (const [clip, weight] of Object.entries(weights)) expect(found[clip]).toBeCloseTo(weight, 9);
});

test.each([
  [
    { a: 1 / 3, b: 1 / 3, c: 1 / 3 },
    { a: 34, b: 33, c: 33 },
  ],
  [
    { a: 0.625, b: 0.375 },
    { a: 63, b: 37 },
  ],
  [
    { a: 1, b: 0 },
    { a: 100, b: 0 },
  ],
])("%j is %j per cent, which sum to 100", (shares, percent) => expect(wholePercent(shares)).toEqual(percent));
