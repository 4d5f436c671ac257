import * as THREE from "three";
import { describe, expect, it } from "vitest";
import type { CastHello } from "../net/protocol";
import type { CastFrame } from "../net/wire";
import { PosedModel } from "./posedModel";
import type { Model } from "./model";

function morphing(targets: number): THREE.Mesh {
  const geometry = new THREE.BufferGeometry().setAttribute(
    "position",
    new THREE.Float32BufferAttribute(new Float32Array(9), 3),
  );
  geometry.morphAttributes["position"] = Array.from(
    { length: targets },
    () => new THREE.Float32BufferAttribute(new Float32Array(9), 3),
  );
  return new THREE.Mesh(geometry);
}

/**
 * Nodes of the file: 0 a face with two targets below node 2, 1 a tail with one, 2 the body. Joints, parents
 * first: 2, 0, 1.
 */
function model(): Model {
  const [face, tail, body, scene] = [morphing(2), morphing(1), new THREE.Object3D(), new THREE.Group()];
  body.add(face, tail);
  scene.add(body);
  return {
    url: "",
    scene,
    nodes: [face, tail, body],
    targets: [2, 1, 0],
    materials: new Map(),
    materialCount: 0,
    skinJoints: new Set(),
    skinEnds: new Map(),
  };
}

const cast = {
  joints: 3,
  weights: 3,
  names: ["body", "face", "tail"],
  nodes: [2, 0, 1],
  parents: [-1, 0, 0],
} as unknown as CastHello;

/** Two actors; number i of an array is i, so that a wrong row or joint shows. */
function frame(): CastFrame {
  const count = (size: number): Float32Array => Float32Array.from({ length: size }, (_, i) => i);
  const rotation = Float32Array.from({ length: 24 }, (_, i) => (i % 4 === 3 ? 1 : 0));
  const root = new Float32Array([0, 0, 0, 0, 0, 0, 1, 5, 0, 7, 0, 1, 0, 0]);
  const sizes = { actors: 2, joints: 3, weightCount: 3, layers: 1 };
  return {
    ...sizes,
    translation: count(18),
    rotation,
    scale: new Float32Array(18).fill(1),
    weights: count(6),
    root,
    phase: count(2),
    blend: count(2),
    state: new Uint32Array(2),
  };
}

function posed(row: number): PosedModel {
  const view = new PosedModel(1, cast, model(), false);
  view.apply(frame(), row);
  view.root.updateMatrixWorld(true);
  return view;
}

describe("PosedModel", () => {
  it("writes each joint's transform to the node it is", () => {
    const translations = posed(0).joints.map((joint) => joint!.position.toArray());
    expect(translations).toEqual([
      [0, 1, 2],
      [3, 4, 5],
      [6, 7, 8],
    ]);
  });

  it("takes morph weights in the order of the file's nodes", () => {
    const [, face, tail] = posed(1).joints as THREE.Mesh[];
    expect([face!.morphTargetInfluences, tail!.morphTargetInfluences]).toEqual([[3, 4], [5]]);
  });

  it("stands where the actor's root is, turned as it is", () => {
    // Root of the second actor: (5, 0, 7), half a turn about y; its body is at (9, 10, 11) in its own space.
    const world = posed(1).jointPositions(new Float32Array(9));
    expect([...world.slice(0, 3)].map((value) => Math.round(value * 1e4) / 1e4)).toEqual([-4, 10, -4]);
  });

  it("takes the matrices of root and joints from a server that skins, until the next pose", () => {
    const view = posed(1);
    const at = (x: number): number[] => new THREE.Matrix4().makeTranslation(x, 0, 0).toArray();
    view.place(new Float32Array([at(9), at(1), at(2), at(3)].flat()));
    expect(view.root.position.toArray()).toEqual([9, 0, 0]);
    expect([...view.jointPositions(new Float32Array(9))]).toEqual([1, 0, 0, 2, 0, 0, 3, 0, 0]);
    view.apply(frame(), 0);
    view.root.updateMatrixWorld(true);
    expect([...view.jointPositions(new Float32Array(9)).slice(0, 3)]).toEqual([0, 1, 2]);
  });

  it("has the box of the pose that the server gave, around its root", () => {
    const view = posed(0);
    const at = (x: number): number[] => new THREE.Matrix4().makeTranslation(x, 0, 0).toArray();
    view.place(new Float32Array([at(9), at(10), at(12), at(14)].flat()));
    const { min, max } = view.box();
    expect([min.x, max.x]).toEqual([3, 5]);
  });

  it("leaves the model it was cloned from alone", () => {
    const original = model();
    new PosedModel(1, cast, original, false).apply(frame(), 1);
    expect(original.nodes[2]!.position.toArray()).toEqual([0, 0, 0]);
  });
});
