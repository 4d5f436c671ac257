import * as THREE from "three";
import { expect, test } from "vitest";
import type { Part } from "./crowdParts";
import { largestDifference } from "./vertexDifference";

/** Two primitives in one part: vertices 0 1 2 and 3 4 5, whose triangle goes 5 4 3; `skinned`: the second. */
function part(skinned: boolean): Part {
  const geometry = new THREE.BufferGeometry().setIndex([0, 1, 2, 5, 4, 3]);
  const source = { vertices: 3, corners: 3 };
  return {
    geometry,
    like: new THREE.Mesh(),
    sources: [
      { ...source, primitive: 1, firstVertex: 0, firstCorner: 0, skinned: false },
      { ...source, primitive: 0, firstVertex: 3, firstCorner: 3, skinned },
    ],
  } as unknown as Part;
}

/** Vertices at these x. */
const gpu = (...xs: number[]): Float32Array => Float32Array.from(xs.flatMap((x) => [x, 0, 0, 1]));
const server = (order: number[] | null, ...xs: number[]) => ({
  places: Float64Array.from(xs.flatMap((x) => [x, 0, 0])),
  order,
});

test("vertices are compared with the vertices of their primitive", () => {
  const primitives = [server(null, 30, 40, 50.5), server(null, 0, 10, 20)];
  expect(largestDifference(part(true), gpu(0, 10, 20, 30, 40, 50), primitives, "linear")).toBe(0.5);
});

test("pieces are compared corner by corner; what follows no bones is whole on the server", () => {
  const torn = gpu(0, 10, 20, 50, 40, 30);
  const rigid = server([0, 1, 2], 0, 10, 20);
  expect(largestDifference(part(true), torn, [server([2, 0, 1], 40, 30, 50), rigid], "parts")).toBe(0);
  expect(largestDifference(part(false), torn, [server(null, 30, 40, 50), rigid], "parts")).toBe(0);
});

test("NaN and another number of vertices are no proof", () => {
  const primitives = [server(null, 30, 40, 50), server(null, 0, 10, 20)];
  expect(largestDifference(part(true), gpu(0, 10, NaN, 30, 40, 50), primitives, "linear")).toBeNaN();
  expect(() => largestDifference(part(true), gpu(0), [server(null, 1), server(null, 1)], "linear")).toThrow(
    "1 vert",
  );
});
