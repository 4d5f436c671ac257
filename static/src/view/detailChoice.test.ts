import * as THREE from "three";
import { expect, it } from "vitest";
import { DetailChoice, levelBySize, pixelsPerMetre } from "./detailChoice";

const levels = [0.001, 0.002, 0.004, 0.008].map((error_m, k) => ({ steps: k + 1, error_m }));

it("a metre fills the picture where the camera sees a metre", () => {
  expect(pixelsPerMetre(0.5, 90, 600)).toBeCloseTo(600);
  expect(pixelsPerMetre(5, 90, 600)).toBeCloseTo(60);
});

it("the coarsest level whose error is below a pixel", () => {
  expect(levelBySize(levels, 2000, 1)).toBe(0);
  expect(levelBySize(levels, 1000, 1)).toBe(1);
  expect(levelBySize(levels, 300, 1)).toBe(2);
  expect(levelBySize(levels, 1, 1)).toBe(4);
  expect(levelBySize(levels, 300)).toBe(2);
  expect(levelBySize(levels, 200)).toBe(2);
});

it("a hand has its way, as far as the model goes", () => {
  const choice = new DetailChoice();
  const camera = new THREE.PerspectiveCamera(90);
  expect(choice.levelAt(levels, 1e6, camera, 600)).toBe(4);
  choice.byHand.value = 1;
  expect(choice.levelAt(levels, 1e6, camera, 600)).toBe(1);
  choice.byHand.value = 9;
  expect(choice.levelAt(levels, 0.1, camera, 600)).toBe(4);
});
