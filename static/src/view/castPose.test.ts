import * as THREE from "three";
import { expect, it } from "vitest";
import type { CastFrame } from "../net/wire";
import { CastPose } from "./castPose";

const PARENTS = [-1, 0, 1, 0];
/** Numbers that look random, the same in every run. */
const spread = (count: number, seed: number): Float32Array =>
  Float32Array.from({ length: count }, (_, i) => Math.sin(12.9898 * (i + seed)) * 2);

function turns(count: number, seed: number): Float32Array {
  const numbers = spread(4 * count, seed);
  for (let at = 0; at < numbers.length; at += 4)
    numbers.set(new THREE.Quaternion().fromArray(numbers, at).normalize().toArray(), at);
  return numbers;
}

function frame(actors: number): CastFrame {
  const root = new Float32Array(7 * actors);
  for (let row = 0; row < actors; row++) {
    root.set(spread(3, 40 + row), 7 * row);
    root.set(turns(1, 50 + row), 7 * row + 3);
  }
  const joints = PARENTS.length;
  return {
    actors,
    joints,
    weightCount: 0,
    layers: 0,
    translation: spread(3 * joints * actors, 1),
    rotation: turns(joints * actors, 2),
    scale: spread(3 * joints * actors, 3),
    weights: new Float32Array(0),
    root,
    phase: new Float32Array(0),
    blend: new Float32Array(0),
    state: new Uint32Array(0),
  };
}

/** The same by three's objects. */
function objectsOf(shown: CastFrame, row: number): THREE.Object3D[] {
  const root = new THREE.Group();
  root.position.fromArray(shown.root, 7 * row);
  root.quaternion.fromArray(shown.root, 7 * row + 3);
  const objects = PARENTS.map(() => new THREE.Object3D());
  objects.forEach((object, joint) => {
    const at = row * PARENTS.length + joint;
    object.position.fromArray(shown.translation, 3 * at);
    object.quaternion.fromArray(shown.rotation, 4 * at);
    object.scale.fromArray(shown.scale, 3 * at);
    (objects[PARENTS[joint]!] ?? root).add(object);
  });
  root.updateMatrixWorld(true);
  return [root, ...objects];
}

it("three actors have the matrices of three's objects", () => {
  const [pose, shown] = [new CastPose(3, PARENTS), frame(3)];
  pose.take(shown);
  for (const row of [0, 1, 2])
    objectsOf(shown, row).forEach(({ matrixWorld }, k) =>
      pose.world(row, k - 1).forEach((value, i) => expect(value).toBeCloseTo(matrixWorld.elements[i]!, 10)),
    );
});

it("matrices of another cast are refused", () => {
  const pose = new CastPose(1, PARENTS);
  pose.place(0, new Float32Array(16).fill(7));
  expect(pose.world(0, -1)[0]).toBe(1);
});
