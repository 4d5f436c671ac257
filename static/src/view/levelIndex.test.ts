import * as THREE from "three";
import { expect, it } from "vitest";
import { levelIndex } from "./levelIndex";

/** A square of two triangles, 0 1 2 and 0 2 3. */
function square(indexed: boolean): THREE.BufferGeometry {
  const geometry = new THREE.BufferGeometry();
  const corners = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0];
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(corners, 3));
  return indexed ? geometry.setIndex([0, 1, 2, 0, 2, 3]) : geometry;
}

const piece = { firstVertex: 0, vertices: 4, firstCorner: 0, corners: 6 };
const collapses = { vertices: [3, 2], onto: [2, 1], steps: [0, 1] };

it("a triangle with two corners at one vertex is gone", () => {
  expect([...levelIndex(square(true), [{ ...piece, collapses }], 1)!.array]).toEqual([0, 1, 2]);
  expect([...levelIndex(square(true), [{ ...piece, collapses }], 2)!.array]).toEqual([]);
});

it("pieces in one geometry collapse apart, those without an order stay", () => {
  const two = [
    { firstVertex: 0, vertices: 4, firstCorner: 0, corners: 3, collapses: null },
    {
      firstVertex: 0,
      vertices: 4,
      firstCorner: 3,
      corners: 3,
      collapses: { ...collapses, vertices: [3, 0] },
    },
  ];
  expect([...levelIndex(square(true), two, 1)!.array]).toEqual([0, 1, 2]);
  expect(levelIndex(square(true), [{ ...piece, collapses: null }], 1)).toBeNull();
});

it("vertices that are drawn in their order get an index", () => {
  const three = { ...piece, vertices: 3, corners: 3, collapses: { vertices: [], onto: [], steps: [] } };
  expect([...levelIndex(square(false), [three], 1)!.array]).toEqual([0, 1, 2]);
});
