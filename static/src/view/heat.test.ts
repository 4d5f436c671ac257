import * as THREE from "three";
import { describe, expect, it } from "vitest";
import { heat, weightsOf } from "./heat";

/** Vertex 0 follows matrix 0, vertex 1 both (the second twice), vertex 2 nothing. */
function skin(): THREE.BufferGeometry {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(new Float32Array(9), 3));
  const joints = new THREE.Uint16BufferAttribute([0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0], 4);
  geometry.setAttribute("skinIndex", joints);
  const weights = [1, 0, 0, 0, 0.25, 0.5, 0.25, 0, 0, 0, 0, 0];
  return geometry.setAttribute("skinWeight", new THREE.Float32BufferAttribute(weights, 4));
}

function box(): THREE.Mesh {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(new Float32Array(6), 3));
  return new THREE.Mesh(geometry);
}

describe("weightsOf", () => {
  it("adds up the influences of the joint", () => {
    expect([...weightsOf(skin(), (follow) => follow === 0)]).toEqual([1, 0.25, 0]);
    expect([...weightsOf(skin(), (follow) => follow === 1)]).toEqual([0, 0.75, 0]);
    expect([...weightsOf(skin(), () => false)]).toEqual([0, 0, 0]);
  });

  it("counts the influences after the fourth", () => {
    const geometry = skin();
    geometry.setAttribute("moreJoints", new THREE.Uint16BufferAttribute(new Uint16Array(12).fill(7), 4));
    const more = [0.5, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0];
    geometry.setAttribute("moreWeights", new THREE.Float32BufferAttribute(more, 4));
    expect([...weightsOf(geometry, (follow) => follow === 7)]).toEqual([0.5, 0, 0]);
  });
});

it("heat is written again into the same attribute", () => {
  const mesh = box();
  heat(mesh, Float32Array.of(0, 1));
  const first = mesh.geometry.getAttribute("heat");
  heat(mesh, Float32Array.of(0.5, 0));
  expect(mesh.geometry.getAttribute("heat")).toBe(first);
  expect([...first.array]).toEqual([0.5, 0]);
});
