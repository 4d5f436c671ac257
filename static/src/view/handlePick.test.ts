import * as THREE from "three";
import { describe, expect, it } from "vitest";
import { drawnDiscs, handleAt, metresOfPixel } from "./handlePick";

const camera = new THREE.PerspectiveCamera(90, 1);
camera.position.set(0, 0, 5);
camera.updateMatrixWorld();
const canvas = {
  getBoundingClientRect: () => ({ left: 100, top: 50, width: 200, height: 200 }),
} as HTMLCanvasElement;

function ball(x: number, y: number, z: number, radius: number): THREE.Object3D {
  const made = new THREE.Object3D();
  made.position.set(x, y, z);
  made.scale.setScalar(radius);
  return made;
}

describe("the discs of balls", () => {
  it("have the place and the radius of the picture", () => {
    // 5 metres away, a field of 90 degrees shows 10 metres on 200 pixels.
    expect(metresOfPixel(camera, 200, new THREE.Vector3())).toBeCloseTo(0.05);
    const discs = drawnDiscs(
      Object.entries({ a: ball(1, 2, 0, 0.5), b: ball(0, 0, 0, 0.5) }),
      camera,
      canvas,
    );
    expect([discs.get("a")!.x, discs.get("a")!.y].map(Math.round)).toEqual([220, 110]);
    expect(discs.get("b")!.radius).toBeCloseTo(10);
  });

  it("leave out what is behind the camera", () => {
    expect(drawnDiscs([["behind", ball(0, 0, 9, 0.5)]], camera, canvas).size).toBe(0);
  });
});

describe("a press", () => {
  const discs = new Map([
    ["small", { x: 0, y: 0, radius: 3 }],
    ["large", { x: 60, y: 0, radius: 30 }],
  ]);
  const at = (clientX: number, pointerType = "mouse") =>
    handleAt(discs, { clientX, clientY: 0, pointerType });

  it("takes the handle that it is on", () => {
    expect([at(2), at(89)]).toEqual(["small", "large"]);
  });

  it("takes a small handle that it only just missed, a finger from farther away", () => {
    expect([at(-11), at(-13), at(-21, "touch"), at(-23, "touch")]).toEqual(["small", null, "small", null]);
  });

  it("takes the nearest one of two", () => {
    const near = new Map([
      ["a", { x: 0, y: 0, radius: 3 }],
      ["b", { x: 10, y: 0, radius: 3 }],
    ]);
    const found = [4, 6].map((clientX) => handleAt(near, { clientX, clientY: 0, pointerType: "mouse" }));
    expect(found).toEqual(["a", "b"]);
  });
});
