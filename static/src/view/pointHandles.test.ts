import * as THREE from "three";
import { describe, expect, it } from "vitest";
import { onFacingPlane } from "./pointHandles";

describe("dragging in the plane that faces the camera", () => {
  const camera = new THREE.PerspectiveCamera();
  camera.position.set(0, 0, 5);
  camera.updateMatrixWorld();

  it("keeps the distance from the camera's plane", () => {
    const ray = new THREE.Ray(new THREE.Vector3(0, 0, 5), new THREE.Vector3(1, 0, -4).normalize());
    const place = onFacingPlane(ray, camera, new THREE.Vector3(0.2, 0.7, 1));
    expect(place?.toArray().map((x) => Math.round(x * 1e6) / 1e6)).toEqual([1, 0, 1]);
  });

  it("does not find a place behind the camera", () => {
    const ray = new THREE.Ray(new THREE.Vector3(0, 0, 5), new THREE.Vector3(0, 0, 1));
    expect(onFacingPlane(ray, camera, new THREE.Vector3(0, 0, 1))).toBeNull();
  });
});
