import * as THREE from "three";
import { expect, test } from "vitest";
import { framed, withHeadroom } from "./framing";

const box = new THREE.Box3(new THREE.Vector3(-0.5, 0, -0.3), new THREE.Vector3(0.5, 2, 0.3));

test("the whole character has room above its head to jump, as high as the walker does", () => {
  const { min, max } = withHeadroom(framed(box, "whole"));
  expect(min).toEqual(box.min);
  expect([max.x, max.y, max.z]).toEqual([0.5, 2.32, 0.3]);
});

test("upper body and face end at the top of the head", () => {
  expect(framed(box, "upper body").min.y).toBe(1);
  expect(framed(box, "face").min.y).toBeCloseTo(1.6);
  for (const framing of ["upper body", "face"] as const) expect(framed(box, framing).max.y).toBeCloseTo(2);
});

test("wide has the character in the middle of two and a half times its size", () => {
  const wide = framed(box, "wide");
  expect(wide.getSize(new THREE.Vector3()).toArray()).toEqual([2.5, 5, 1.5]);
  expect(wide.getCenter(new THREE.Vector3())).toEqual(box.getCenter(new THREE.Vector3()));
});
