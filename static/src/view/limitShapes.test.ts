import { expect, test } from "vitest";
import * as THREE from "three";
import { arc, limitShape, swung } from "./limitShapes";

test("an arc begins and ends at its limits, right-handed about its axis", () => {
  const shape = { lines: [] as number[], faces: [] as number[] };
  arc(shape, new THREE.Vector3(0, 0, 1), new THREE.Vector3(1, 0, 0), 0, Math.PI / 2, 1);
  expect(shape.faces.slice(3, 6)).toEqual([1, 0, 0]);
  const end = shape.faces.slice(-3);
  expect(end[0]).toBeCloseTo(0);
  expect(end[1]).toBeCloseTo(1);
});

test("a swing about X tips Y towards Z", () => {
  const { x, y, z } = swung(Math.PI / 2, 0);
  expect([x, y, z].map((v) => Math.round(v * 100) / 100)).toEqual([0, 0, 0.7]);
});

test("a cone passes through its four limits", () => {
  const limit = {
    joint: "B",
    type: "spherical",
    form: "",
    symbol: "3R",
    shape: "cone" as const,
    frame: [0, 0, 0, 1],
    rest: [0, 0, 0, 0, 0, 0, 1],
    pitch: 0,
    freedoms: [
      { name: "swing_x", is_angle: true, minimum: -30, maximum: 60 },
      { name: "swing_z", is_angle: true, minimum: -40, maximum: 40 },
    ],
  };
  const { faces } = limitShape(limit, new THREE.Vector3(0, 1, 0), 1);
  const heights = faces.filter((_, at) => at % 9 === 4).map((y) => Math.acos(y / 0.7) / (Math.PI / 180));
  expect(Math.max(...heights)).toBeCloseTo(60, 3);
  expect(heights[36]).toBeCloseTo(30, 3);
  expect(heights[18]).toBeCloseTo(40, 3);
});
