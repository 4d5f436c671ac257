/** Finds the values with which a point of the scene is drawn nearest to the pointer. */

import * as THREE from "three";

export interface Range {
  low: number;
  high: number;
  /** The most that a value changes in one step of the search, and the length of a trial step. */
  step: number;
}

const ROUNDS = 12;

/**
 * Returns `values` moved, each within its range, until the point that `drawn` returns for them (pixels) is as
 * near as it comes to `pointer`: Gauss and Newton's method from where the values are, so a screw goes on turning.
 */
export function follow(
  drawn: (values: readonly number[]) => THREE.Vector2,
  values: readonly number[],
  ranges: readonly Range[],
  pointer: THREE.Vector2,
): number[] {
  let now = [...values];
  let missed = drawn(now).distanceToSquared(pointer);
  for (let round = 0; round < ROUNDS; round++) {
    const next = stepped(drawn, now, ranges, pointer);
    const left = drawn(next).distanceToSquared(pointer);
    if (left >= missed - 1e-9) return now;
    [now, missed] = [next, left];
  }
  return now;
}

function stepped(
  drawn: (values: readonly number[]) => THREE.Vector2,
  values: readonly number[],
  ranges: readonly Range[],
  pointer: THREE.Vector2,
): number[] {
  const here = drawn(values);
  const [dx, dy] = [pointer.x - here.x, pointer.y - here.y];
  const slopes = values.map((value, k) => {
    const trial = 0.01 * ranges[k]!.step;
    return drawn(values.map((other, j) => (j === k ? value + trial : other)))
      .sub(here)
      .divideScalar(trial);
  });
  const wanted = solved(slopes, dx, dy);
  const scale = Math.min(1, ...wanted.map((change, k) => ranges[k]!.step / Math.max(Math.abs(change), 1e-9)));
  return values.map((value, k) =>
    THREE.MathUtils.clamp(value + scale * wanted[k]!, ranges[k]!.low, ranges[k]!.high),
  );
}

/** The changes of one or two values that move the point by (dx, dy) at these slopes, damped. */
function solved(slopes: readonly THREE.Vector2[], dx: number, dy: number): number[] {
  const [a, b] = [slopes[0]!, slopes[1]];
  const right = slopes.map((slope) => slope.x * dx + slope.y * dy);
  const aa = a.lengthSq() * 1.001 + 1e-9;
  if (!b) return [right[0]! / aa];
  const [bb, ab] = [b.lengthSq() * 1.001 + 1e-9, a.dot(b)];
  const all = Math.max(aa * bb - ab * ab, 1e-12);
  return [(right[0]! * bb - right[1]! * ab) / all, (right[1]! * aa - right[0]! * ab) / all];
}
