import * as THREE from "three";
import { expect, test } from "vitest";
import { poseWords, turnsOf } from "./pose";

const turned = (x: number, y: number, z: number): THREE.Quaternion =>
  new THREE.Quaternion().setFromEuler(
    new THREE.Euler(...([x, y, z].map((turn) => THREE.MathUtils.degToRad(turn)) as [number, number, number])),
  );

test("turns are degrees about X, Y and Z", () => {
  turnsOf(turned(30, -20, 75)).forEach((turn, axis) => expect(turn).toBeCloseTo([30, -20, 75][axis]!));
});

test("a pose is said in degrees and metres, and zero has no sign", () => {
  const place = new THREE.Vector3(0.12, -0.0001, 0.3);
  expect(poseWords("local", place, turned(0, -0.01, 4))).toBe("local 0.0° 0.0° 4.0° at 0.120 0.000 0.300 m");
});
