import * as THREE from "three";
import { expect, test } from "vitest";
import { geometryIn, heaviestBone, rigidGeometry, tornGeometry } from "./skinWays";

/** Two triangles, 0 1 2 and 2 1 3; the first is nearer to bone 3, the second to bone 1. */
function strip(): THREE.BufferGeometry {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute(
    "position",
    new THREE.BufferAttribute(
      new Float32Array(12).map((_, k) => k),
      3,
    ),
  );
  const bones = [3, 1, 0, 0, 3, 1, 0, 0, 1, 3, 0, 0, 1, 0, 0, 0];
  const weights = [1, 0, 0, 0, 0.6, 0.4, 0, 0, 0.5, 0.5, 0, 0, 0.9, 0.1, 0, 0];
  geometry.setAttribute("skinIndex", new THREE.BufferAttribute(new Uint16Array(bones), 4));
  geometry.setAttribute("skinWeight", new THREE.BufferAttribute(new Float32Array(weights), 4));
  geometry.setIndex([0, 1, 2, 2, 1, 3]);
  return geometry;
}

function bonesOf(geometry: THREE.BufferGeometry): number[] {
  const { skinIndex, skinWeight, position } = geometry.attributes;
  for (let vertex = 0; vertex < position!.count; vertex++) expect(skinWeight!.getX(vertex)).toBe(1);
  return Array.from({ length: position!.count }, (_, vertex) => skinIndex!.getX(vertex));
}

test("of equal bones the first of the skin counts", () =>
  expect(heaviestBone({ bones: [7, 2, 7], weights: [0.2, 0.50001, 0.3] })).toBe(2));

test("rigid skin has one bone a vertex, as the server's", () => {
  const source = strip();
  const geometry = rigidGeometry(source);
  expect(bonesOf(geometry)).toEqual([3, 3, 1, 1]);
  expect(geometry.attributes.position).toBe(source.attributes.position);
  expect(geometry.index).toBe(source.index);
});

test("pieces have corners of their own", () => {
  const geometry = tornGeometry(strip());
  expect(geometry.index).toBeNull();
  expect(bonesOf(geometry)).toEqual([3, 3, 3, 1, 1, 1]);
  expect(Array.from({ length: 6 }, (_, k) => geometry.attributes.position!.getX(k))).toEqual([
    0, 3, 6, 6, 3, 9,
  ]);
});

test("lines and points are not torn", () => {
  const geometry = strip();
  expect(geometryIn(geometry, "parts", false)).toBe(geometryIn(geometry, "rigid", true));
  expect(geometryIn(geometry, "parts", true).index).toBeNull();
  for (const way of ["linear", "dual-quaternion"] as const)
    expect(geometryIn(geometry, way, true)).toBe(geometry);
});

test("influences after the fourth count, and are gone in a rigid skin", () => {
  const geometry = strip();
  geometry.setAttribute("moreJoints", new THREE.BufferAttribute(new Uint16Array(16).fill(9), 4));
  const weights = new Float32Array(16);
  weights[0] = 2;
  geometry.setAttribute("moreWeights", new THREE.BufferAttribute(weights, 4));
  const skin = rigidGeometry(geometry);
  expect(bonesOf(skin)).toEqual([9, 3, 1, 1]);
  expect(skin.hasAttribute("moreWeights")).toBe(false);
});
