import * as THREE from "three";
import { expect, it } from "vitest";
import type { CastFrame } from "../net/wire";
import { CastPose } from "./castPose";
import { PoseTexture } from "./poseTexture";

const matrix = (x: number): number[] => new THREE.Matrix4().makeTranslation(x, 0, 0).toArray();

/** Two actors with one joint and two morph weights; their joints are at 10 and 20. */
function pose(): CastPose {
  const cast = new CastPose(2, [-1]);
  [10, 20].forEach((x, row) => cast.matrices.set(matrix(x), cast.indexOf(row, 0)));
  cast.frame = { weightCount: 2, weights: Float32Array.of(0.1, 0.2, 0.3, 0.4) } as CastFrame;
  return cast;
}

const follows = [
  { joint: 0, inverse: matrix(1) },
  { joint: -1, inverse: matrix(0) },
];

it("an actor has its matrices, then its weights, from the texel that its instance is told", () => {
  const texture = new PoseTexture(2, follows, 2);
  texture.fill(pose());
  const at = 4 * texture.start(1);
  expect(texture.numbers[at + 12]).toBe(21);
  expect(texture.numbers[at + 16 + 12]).toBe(0);
  const weight = (k: number): number => texture.numbers[at + texture.weightAt(k)]!;
  expect([weight(0), weight(1)].map((value) => Math.round(10 * value))).toEqual([3, 4]);
});

it("no matrix goes over the end of a row of texels", () => {
  for (const actors of [1, 7, 1000]) {
    const texture = new PoseTexture(actors, follows, 5);
    const { width, height } = texture.boneTexture!.image as { width: number; height: number };
    expect([width % 4, texture.start(actors - 1) % 4]).toEqual([0, 0]);
    expect(width * height).toBeGreaterThanOrEqual((actors * texture.stride) / 4);
  }
});

it("for dual quaternions the last row is the rotation, else 0 0 0 1", () => {
  const [texture, cast] = [new PoseTexture(2, follows, 0), pose()];
  cast.matrices.set(new THREE.Matrix4().makeRotationZ(Math.PI / 2).toArray(), cast.indexOf(0, 0));
  const lastRow = (): number[] => [3, 7, 11, 15].map((k) => Math.abs(texture.numbers[k]!));
  texture.turning = true;
  texture.fill(cast);
  [0, 0, Math.SQRT1_2, Math.SQRT1_2].forEach((value, k) => expect(lastRow()[k]).toBeCloseTo(value));
  texture.turning = false;
  texture.fill(cast);
  expect(lastRow()).toEqual([0, 0, 0, 1]);
});
