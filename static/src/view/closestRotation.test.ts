import * as THREE from "three";
import { expect, test } from "vitest";
import { closestRotation } from "./closestRotation";

const TURN = new THREE.Quaternion().setFromEuler(new THREE.Euler(0.4, -1.1, 2.3));
const FRAME = new THREE.Quaternion().setFromEuler(new THREE.Euler(-0.7, 0.5, 0.2));

/** R · F · S · Fᵀ: a rotation after a stretch along oblique axes. */
function stretched(turn: THREE.Quaternion, size: [number, number, number]): THREE.Matrix4 {
  const frame = new THREE.Matrix4().makeRotationFromQuaternion(FRAME);
  const sizes = new THREE.Matrix4().makeScale(...size);
  const shape = frame.clone().multiply(sizes).multiply(frame.clone().transpose());
  return new THREE.Matrix4().makeRotationFromQuaternion(turn).multiply(shape);
}

function angleTo(matrix: THREE.Matrix4, turn: THREE.Quaternion): number {
  return new THREE.Quaternion(...closestRotation(matrix.elements)).angleTo(turn);
}

test("a rotation is its own", () => expect(angleTo(stretched(TURN, [1, 1, 1]), TURN)).toBeLessThan(1e-6));

test.each([
  [0.5, 1, 2],
  [1, 1, 0],
  [3, 1, 1e-4],
  [0.01, 0.01, 0.01],
] as [number, number, number][])("a stretch of %f %f %f leaves the rotation", (...size) =>
  expect(angleTo(stretched(TURN, size), TURN)).toBeLessThan(1e-5),
);

test("a mirror has the rotation of the opposite matrix", () =>
  expect(angleTo(stretched(TURN, [-1, -2, -1]), TURN)).toBeLessThan(1e-5));

test("zeros and NaN are no rotation", () => {
  expect(closestRotation(new Float32Array(16))).toEqual([0, 0, 0, 1]);
  expect(closestRotation(new Float32Array(16).fill(NaN))).toEqual([0, 0, 0, 1]);
});
