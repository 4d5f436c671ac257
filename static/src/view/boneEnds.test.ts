import * as THREE from "three";
import { describe, expect, it } from "vitest";
import { boneEnds, skinEnds } from "./boneEnds";

/**
 * A thigh at (0, 2, 0), a foot 1 below it and turned a quarter about y; the foot's skin reaches 0.4 along the
 * world's z, the thigh's hangs down.
 */
function leg(): { scene: THREE.Group; nodes: THREE.Object3D[] } {
  const [scene, thigh, foot] = [new THREE.Group(), new THREE.Bone(), new THREE.Bone()];
  thigh.position.set(0, 2, 0);
  foot.position.set(0, -1, 0);
  foot.rotation.y = Math.PI / 2;
  thigh.add(foot);
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute([0, 1.5, 0, 0, 1, 0.1, 0, 1, 0.4], 3));
  geometry.setAttribute(
    "skinIndex",
    new THREE.Uint16BufferAttribute([0, 1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0], 4),
  );
  geometry.setAttribute(
    "skinWeight",
    new THREE.Float32BufferAttribute([1, 0, 0, 0, 1, 0, 0, 0, 0.2, 0.8, 0, 0], 4),
  );
  const mesh = new THREE.SkinnedMesh(geometry);
  scene.add(thigh, mesh);
  scene.updateMatrixWorld(true);
  mesh.bind(new THREE.Skeleton([thigh, foot]), new THREE.Matrix4());
  return { scene, nodes: [thigh, foot] };
}

const plan = { joints: [0, 1], segments: [[0, 1]] as [number, number][] };
const round = (at: THREE.Vector3): number[] => at.toArray().map((value) => Math.round(value * 1e6) / 1e6 + 0);

describe("boneEnds", () => {
  it("follows the skin of a joint without children, in the joint's own space", () => {
    const { scene, nodes } = leg();
    const ends = boneEnds(
      plan,
      { nodes: [0, 1], names: ["thigh", "foot"] },
      { scene, nodes, skinEnds: skinEnds(scene) },
    );
    expect(ends.map(({ joint }) => joint)).toEqual([1]);
    expect(round(nodes[1]!.localToWorld(ends[0]!.at.clone()))).toEqual([0, 1, 0.4]);
  });

  it("goes half as far straight on where there is no skin", () => {
    const { scene, nodes } = leg();
    const [end] = boneEnds(
      plan,
      { nodes: [0, 1], names: ["thigh", "foot"] },
      { scene, nodes, skinEnds: new Map() },
    );
    expect(round(nodes[1]!.localToWorld(end!.at.clone()))).toEqual([0, 0.5, 0]);
  });

  it("adds nothing to a joint that only marks an end", () => {
    const { scene, nodes } = leg();
    const ends = (name: string): number =>
      boneEnds(plan, { nodes: [0, 1], names: ["a", name] }, { scene, nodes, skinEnds: new Map() }).length;
    expect(["foot_end", "Foot.End", "HeadNub", "friend"].map(ends)).toEqual([0, 0, 0, 1]);
  });

  it("adds nothing to a goal that hangs on no skin", () => {
    const { scene, nodes } = leg();
    const elsewhere = new Map([[new THREE.Object3D(), new THREE.Vector3(1, 0, 0)]]);
    expect(
      boneEnds(plan, { nodes: [0, 1], names: ["root", "goal"] }, { scene, nodes, skinEnds: elsewhere }),
    ).toEqual([]);
  });

  it("knows rigid parts as well, for the joint they hang on", () => {
    const [scene, head, helmet] = [
      new THREE.Group(),
      new THREE.Bone(),
      new THREE.Mesh(new THREE.BufferGeometry()),
    ];
    helmet.geometry.setAttribute("position", new THREE.Float32BufferAttribute([0, 0, 0, 0, 1, 0], 3));
    helmet.scale.setScalar(3);
    scene.add(head.add(helmet));
    expect(round(skinEnds(scene).get(head)!)).toEqual([0, 3, 0]);
  });
});
