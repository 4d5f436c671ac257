import * as THREE from "three";
import { expect, it } from "vitest";
import { influences } from "./influences";

type Row = [number, number, number, number];

function skin(...sets: [joints: Row, weights: Row][]): THREE.BufferGeometry {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute([0, 0, 0], 3));
  sets.forEach(([joints, weights], set) => {
    geometry.setAttribute(set ? `joints_${set}` : "skinIndex", new THREE.Uint16BufferAttribute(joints, 4));
    geometry.setAttribute(
      set ? `weights_${set}` : "skinWeight",
      new THREE.Float32BufferAttribute(weights, 4),
    );
  });
  return geometry;
}

const rows = ({ attributes }: ReturnType<typeof influences>): Record<string, number[]> =>
  Object.fromEntries(
    Object.entries(attributes).map(([name, { array }]) => [
      name,
      [...array].map((x) => Math.round(1e3 * x) / 1e3),
    ]),
  );

it("the heaviest comes first, weights sum to 1, negative ones are none", () => {
  const made = influences(
    skin([
      [3, 1, 2, 0],
      [0.2, 0.6, -5, 0],
    ]),
    10,
  );
  expect(rows(made)).toEqual({ skinIndex: [11, 13, 11, 11], skinWeight: [0.75, 0.25, 0, 0] });
});

it("all sets count, and a vertex has four more attributes then", () => {
  const made = influences(
    skin(
      [
        [1, 2, 3, 4],
        [0.2, 0.2, 0.2, 0.1],
      ],
      [
        [5, 6, 0, 0],
        [0.25, 0.05, 0, 0],
      ],
    ),
    0,
  );
  expect(rows(made)).toEqual({
    skinIndex: [5, 1, 2, 3],
    skinWeight: [0.25, 0.2, 0.2, 0.2],
    moreJoints: [4, 6, 5, 5],
    moreWeights: [0.1, 0.05, 0, 0],
  });
  expect(made.most).toBe(6);
});

it("a vertex without weights follows its first joint, and without a skin the place it is given", () => {
  expect(
    rows(
      influences(
        skin([
          [7, 0, 0, 0],
          [0, 0, 0, 0],
        ]),
        0,
      ),
    )["skinIndex"]![0],
  ).toBe(7);
  expect(rows(influences(skin(), 5))).toEqual({ skinIndex: [5, 5, 5, 5], skinWeight: [1, 0, 0, 0] });
});
