import * as THREE from "three";
import { describe, expect, it } from "vitest";
import type { CastHello } from "../net/protocol";
import type { CastFrame } from "../net/wire";
import { Crowd } from "./crowd";
import { PosedModel } from "./posedModel";
import type { Model } from "./model";

function mesh(): THREE.Mesh {
  const corners = new THREE.Float32BufferAttribute(new Float32Array(9), 3);
  return new THREE.Mesh(new THREE.BufferGeometry().setAttribute("position", corners));
}

/** Nodes of the file: 0 a face below node 2, 1 a tail, 2 the body. Joints, parents first: 2, 0, 1. */
function model(): Model {
  const [face, tail, body, scene] = [mesh(), mesh(), new THREE.Object3D(), new THREE.Group()];
  body.add(face, tail);
  scene.add(body);
  return {
    url: "",
    scene,
    animations: [],
    nodes: [face, tail, body],
    targets: [0, 0, 0],
    levels: [],
    materials: new Map(),
    materialCount: 0,
    skinJoints: new Set(),
    skinEnds: new Map(),
  };
}

const cast = {
  joints: 3,
  weights: 0,
  names: ["body", "face", "tail"],
  nodes: [2, 0, 1],
  parents: [-1, 0, 0],
  skinning: "linear",
  actors: [{ id: 4 }, { id: 9 }],
} as unknown as CastHello;

/** Two actors; number i of the translations is i, so that a wrong row or joint shows. */
function frame(): CastFrame {
  const rotation = Float32Array.from({ length: 24 }, (_, i) => (i % 4 === 3 ? 1 : 0));
  const sizes = { actors: 2, joints: 3, weightCount: 0, layers: 1 };
  return {
    ...sizes,
    translation: Float32Array.from({ length: 18 }, (_, i) => i),
    rotation,
    scale: new Float32Array(18).fill(1),
    weights: new Float32Array(0),
    root: new Float32Array([0, 0, 0, 0, 0, 0, 1, 5, 0, 7, 0, 1, 0, 0]),
    phase: new Float32Array(2),
    blend: new Float32Array(2),
    state: new Uint32Array(2),
  };
}

const at = (x: number): number[] => new THREE.Matrix4().makeTranslation(x, 0, 0).toArray();
const rounded = (values: Iterable<number>): number[] =>
  [...values].map((value) => Math.round(value * 1e4) / 1e4 + 0);

function posed(row: number): { crowd: Crowd; actor: PosedModel } {
  const crowd = new Crowd(cast, model(), false);
  crowd.take(frame());
  return { crowd, actor: new PosedModel(4, crowd, row) };
}

describe("PosedModel", () => {
  it("stands where the actor's root is, turned as it is", () => {
    // Root of the second actor: (5, 0, 7), half a turn about y; its body is at (9, 10, 11) in its own space.
    const { actor } = posed(1);
    expect(rounded(actor.jointPositions(new Float32Array(9)).slice(0, 3))).toEqual([-4, 10, -4]);
    expect(actor.position.toArray()).toEqual([5, 0, 7]);
    expect(Math.abs(actor.heading)).toBeCloseTo(Math.PI);
  });

  it("tells the place of a joint from its parent, in both streams", () => {
    const { crowd, actor } = posed(0);
    expect(actor.local(2)!.position.toArray()).toEqual([6, 7, 8]);
    crowd.place(0, new Float32Array([at(9), at(1), at(2), at(4)].flat()));
    expect(actor.local(2)!.position.toArray()).toEqual([3, 0, 0]);
    expect(actor.local(3)).toBeNull();
  });

  it("takes the matrices of root and joints from a server that skins, until the next pose", () => {
    const { crowd, actor } = posed(1);
    crowd.place(1, new Float32Array([at(9), at(1), at(2), at(3)].flat()));
    expect(actor.position.toArray()).toEqual([9, 0, 0]);
    expect([...actor.jointPositions(new Float32Array(9))]).toEqual([1, 0, 0, 2, 0, 0, 3, 0, 0]);
    expect(crowd.root.visible).toBe(false);
    crowd.take(frame());
    expect(rounded(actor.jointPositions(new Float32Array(9)).slice(0, 3))).toEqual([-4, 10, -4]);
    expect(crowd.root.visible).toBe(true);
  });

  it("has the box of the pose that the server gave, around its root", () => {
    const { crowd, actor } = posed(0);
    crowd.place(0, new Float32Array([at(9), at(10), at(12), at(14)].flat()));
    const { min, max } = actor.box();
    expect([min.x, max.x]).toEqual([3, 5]);
  });
});
