import * as THREE from "three";
import { expect, it } from "vitest";
import { partsOf } from "./crowdParts";
import type { Model } from "./model";

const red = new THREE.MeshBasicMaterial();
const blue = new THREE.MeshBasicMaterial();

function triangle(material: THREE.Material): THREE.Mesh {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute([0, 0, 0, 1, 0, 0, 0, 1, 0], 3));
  geometry.setIndex([0, 1, 2]);
  return new THREE.Mesh(geometry, material);
}

function skinned(material: THREE.Material, bones: THREE.Bone[]): THREE.SkinnedMesh {
  const { geometry } = triangle(material);
  geometry.setAttribute("skinIndex", new THREE.Uint8BufferAttribute([1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0], 4));
  geometry.setAttribute(
    "skinWeight",
    new THREE.Float32BufferAttribute([1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0], 4),
  );
  const mesh = new THREE.SkinnedMesh(geometry, material);
  mesh.bind(new THREE.Skeleton(bones), new THREE.Matrix4());
  return mesh;
}

function modelOf(nodes: THREE.Object3D[], targets: number[] = nodes.map(() => 0)): Model {
  const scene = new THREE.Group();
  for (const node of nodes) if (!node.parent) scene.add(node);
  return { url: "", scene, nodes, targets } as unknown as Model;
}

it("what shares a material is one part, rigid or skinned", () => {
  const bones = [new THREE.Bone(), new THREE.Bone()];
  const model = modelOf([...bones, triangle(red), triangle(blue), skinned(red, bones)]);
  const { follows, parts, primitives } = partsOf(model);
  expect(primitives).toBe(3);
  expect(parts.map(({ material }) => material)).toEqual([red, blue]);
  expect(follows.map(({ node }) => node)).toEqual([2, 3, 0, 1]);
  expect([...parts[0]!.geometry.getAttribute("skinIndex").array].filter((_, k) => k % 4 === 0)).toEqual([
    0, 0, 0, 3, 2, 2,
  ]);
  expect(parts[0]!.sources).toEqual([
    {
      primitive: 0,
      firstVertex: 0,
      vertices: 3,
      firstCorner: 0,
      corners: 3,
      skinned: false,
      collapses: null,
    },
    { primitive: 2, firstVertex: 3, vertices: 3, firstCorner: 3, corners: 3, skinned: true, collapses: null },
  ]);
});

it("meshes of one skin share its bones", () => {
  const bones = [new THREE.Bone(), new THREE.Bone()];
  const model = modelOf([...bones, skinned(red, bones), skinned(blue, bones)]);
  expect(partsOf(model).follows.map(({ node }) => node)).toEqual([0, 1]);
});

it("the primitives of a mesh on a bone are the bone's", () => {
  const [bone, mesh] = [new THREE.Bone(), new THREE.Group()];
  bone.add(mesh.add(triangle(red), triangle(blue)));
  const { follows, parts } = partsOf(modelOf([bone]));
  expect([follows.length, parts.length]).toEqual([1, 2]);
});

it("a part with morph targets stays alone, and knows its first weight", () => {
  const [face, tail] = [triangle(red), triangle(red)];
  for (const { geometry } of [face, tail])
    geometry.morphAttributes["position"] = [geometry.getAttribute("position")];
  expect(partsOf(modelOf([face, tail], [2, 1])).parts.map(({ firstWeight }) => firstWeight)).toEqual([0, 2]);
});

it("a mirrored rigid mesh is turned the right way out", () => {
  const mesh = triangle(red);
  mesh.scale.x = -1;
  expect([...partsOf(modelOf([mesh])).parts[0]!.geometry.index!.array]).toEqual([0, 2, 1]);
});

it("what is not in the scene is not drawn", () => {
  const [shown, hidden] = [triangle(red), triangle(blue)];
  new THREE.Group().add(hidden);
  expect(partsOf(modelOf([shown, hidden])).parts).toHaveLength(1);
});
