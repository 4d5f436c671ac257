import * as THREE from "three";
import { describe, expect, it } from "vitest";
import { UNIT, place, tetrahedronGeometry } from "./tetrahedron";

const at = (corner: number, matrix: THREE.Matrix4): THREE.Vector3 =>
  new THREE.Vector3(...UNIT[corner]!).applyMatrix4(matrix);

describe("tetrahedron", () => {
  it("has the corners of the spec, base corners equally far apart", () => {
    const [, a, b, c] = UNIT.map((corner) => new THREE.Vector3(...corner));
    expect(a!.distanceTo(b!)).toBeCloseTo(b!.distanceTo(c!), 5);
  });

  it("has faces that look outwards", () => {
    const { position, normal } = tetrahedronGeometry().attributes;
    const centre = new THREE.Vector3(0, 0, 0.25);
    for (let i = 0; i < 12; i += 3) {
      const corner = new THREE.Vector3()
        .fromBufferAttribute(position as THREE.BufferAttribute, i)
        .sub(centre);
      expect(
        corner.dot(new THREE.Vector3().fromBufferAttribute(normal as THREE.BufferAttribute, i)),
      ).toBeGreaterThan(0);
    }
  });

  it("puts base at the start and apex at the end", () => {
    const matrix = place(new THREE.Matrix4(), new THREE.Vector3(1, 2, 3), new THREE.Vector3(1, 0, 3));
    expect(at(0, matrix).distanceTo(new THREE.Vector3(1, 0, 3))).toBeLessThan(1e-6);
    expect(at(1, matrix).y).toBeCloseTo(2, 6);
  });

  it("vanishes where a bone has no length", () => {
    const start = new THREE.Vector3(1, 1, 1);
    expect(at(0, place(new THREE.Matrix4(), start, start)).equals(start)).toBe(true);
  });
});
