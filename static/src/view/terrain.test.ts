import { expect, it } from "vitest";
import { blockEdges, blockTriangles } from "./terrain";

/** The volume that triangles enclose: the sum of signed tetrahedra to the origin. */
function volume(positions: number[]): number {
  let total = 0;
  for (let k = 0; k < positions.length; k += 9) {
    const [ax, ay, az, bx, by, bz, cx, cy, cz] = positions.slice(k, k + 9) as [
      number,
      number,
      number,
      number,
      number,
      number,
      number,
      number,
      number,
    ];
    total += ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
  }
  return total / 6;
}

// The foot of a block stands on the floor at height 0 and adds nothing.
it("a step encloses width times depth times height, its faces turned outwards", () => {
  const step = { corner: [-1, 2], opposite: [1, 2.5], heights: [0.2, 0.2, 0.2, 0.2] };
  expect(volume(blockTriangles(step))).toBeCloseTo(2 * 0.5 * 0.2, 9);
});

it("a slope encloses half of that", () => {
  const slope = { corner: [0, 0], opposite: [2, 3], heights: [0, 0, 0.5, 0.5] };
  expect(volume(blockTriangles(slope))).toBeCloseTo((2 * 3 * 0.5) / 2, 9);
});

it("a slope has four edges round its top, and one down from each corner that is above the floor", () => {
  const edges = blockEdges({ corner: [0, 0], opposite: [2, 3], heights: [0, 0, 0.5, 0.5] });
  const lengths = Array.from({ length: 8 }, (_, k) => edges.slice(6 * k, 6 * k + 6)).map(
    ([ax, ay, az, bx, by, bz]) => Math.hypot(ax! - bx!, ay! - by!, az! - bz!),
  );
  const side = Math.hypot(3, 0.5);
  [side, 2, side, 2, 0, 0.5, 0.5, 0].forEach((length, k) => expect(lengths[k]).toBeCloseTo(length, 9));
});
