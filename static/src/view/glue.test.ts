import * as THREE from "three";
import { expect, it } from "vitest";
import { bonesOf } from "./glue";

it("a vertex follows its heaviest bone", () => {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(new Float32Array(6), 3));
  geometry.setAttribute("skinIndex", new THREE.Uint16BufferAttribute([0, 2, 0, 0, 1, 0, 0, 0], 4));
  const weights = [0.4, 0.6, 0, 0, 1, 0, 0, 0];
  geometry.setAttribute("skinWeight", new THREE.Float32BufferAttribute(weights, 4));
  expect([...bonesOf(geometry)]).toEqual([2, 1]);
  expect([...bonesOf(geometry.deleteAttribute("skinIndex"))]).toEqual([0, 0]);
});
