import * as THREE from "three";
import { expect, it } from "vitest";
import { CrowdGeometry, CrowdMesh, Roster } from "./crowdMesh";
import { PoseTexture } from "./poseTexture";
import { refreshNormals, showNormals } from "./normals";

function triangle(): THREE.Mesh {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute([0, 0, 0, 1, 0, 0, 0, 1, 0], 3));
  geometry.setAttribute("normal", new THREE.Float32BufferAttribute([0, 0, 1, 0, 0, 1, 0, 0, 1], 3));
  return new THREE.Mesh(geometry);
}

const lines = (mesh: THREE.Mesh): THREE.Mesh => mesh.children[0] as THREE.Mesh;

it("each vertex gets a line with a start and a tip", () => {
  const mesh = triangle();
  showNormals(mesh, true);
  const { position, tip } = lines(mesh).geometry.attributes;
  expect([...position!.array]).toEqual([0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0]);
  expect([...tip!.array]).toEqual([0, 1, 0, 1, 0, 1]);
  showNormals(mesh, false);
  expect(lines(mesh).visible).toBe(false);
});

it("the lines follow vertices that the server moved", () => {
  const mesh = triangle();
  showNormals(mesh, true);
  (mesh.geometry.getAttribute("position") as THREE.BufferAttribute).setXYZ(1, 5, 6, 7);
  refreshNormals(mesh);
  expect([...lines(mesh).geometry.getAttribute("position").array.slice(6, 12)]).toEqual([5, 6, 7, 5, 6, 7]);
});

it("a body without normals has no lines", () => {
  const mesh = triangle();
  mesh.geometry.deleteAttribute("normal");
  showNormals(mesh, true);
  expect(mesh.children).toEqual([]);
});

it("the lines of a crowd move with it, and are drawn as often", () => {
  const { geometry } = triangle();
  const [joints, weights] = [new Array(12).fill(0), [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0]];
  geometry.setAttribute("skinIndex", new THREE.Uint16BufferAttribute(joints, 4));
  geometry.setAttribute("skinWeight", new THREE.Float32BufferAttribute(weights, 4));
  const pose = new PoseTexture(3, [{ joint: -1, inverse: new THREE.Matrix4().toArray() }], 0);
  const roster = new Roster([1, 2, 3], pose);
  const mesh = new CrowdMesh(new CrowdGeometry(roster).share(geometry), new THREE.Material(), pose);
  showNormals(mesh, true);
  const twin = mesh.children.at(-1) as CrowdMesh;
  expect(twin.skeleton).toBe(pose);
  expect(twin.geometry.getAttribute("skinWeight").count).toBe(6);
  roster.take([0, 2]);
  expect(twin.geometry).toHaveProperty("instanceCount", 2);
  expect([...twin.geometry.getAttribute("actorId").array].slice(0, 2)).toEqual([1, 3]);
});
