/** Makes the FAQ's tetrahedron (RD2): base at a bone's start, apex at its end. */

import * as THREE from "three";

/** Unit form: apex on +Z, base in the plane z = 0, radius 0.353553. */
export const UNIT: readonly [number, number, number][] = [
  [0, 0, 1],
  [0.353553, 0, 0],
  [-0.176776, 0.306186, 0],
  [-0.176776, -0.306186, 0],
];

const FACES = [0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2];
/** Width of the base, as a share of the bone's length in the unit form. */
const THICKNESS = 0.42;

/** Makes the geometry; every face has its own corners, for flat shading. */
export function tetrahedronGeometry(): THREE.BufferGeometry {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute(
    "position",
    new THREE.Float32BufferAttribute(
      FACES.flatMap((corner) => [...UNIT[corner]!]),
      3,
    ),
  );
  const ends = FACES.map((corner, i) => (corner === 0 ? [0.5, 1] : i % 3 === 1 ? [0, 0] : [1, 0]));
  const base = [0, 0, 1, 0, 0.5, 1]; // the last face has no apex
  const places = [...ends.slice(0, 9).flat(), ...base];
  geometry.setAttribute("uv", new THREE.Float32BufferAttribute(places, 2));
  geometry.computeVertexNormals();
  return geometry;
}

const [CELLS, PIXELS] = [8, 64];
let texture: THREE.DataTexture | null = null;

/** Returns the texture of all tetrahedra: a chequer that is brighter towards the bone's end. */
export function tetrahedronTexture(): THREE.DataTexture {
  if (texture) return texture;
  const data = new Uint8Array(PIXELS * PIXELS * 4).fill(255);
  for (let y = 0; y < PIXELS; y++)
    for (let x = 0; x < PIXELS; x++) {
      const odd = (Math.floor((x * CELLS) / PIXELS) + Math.floor((y * CELLS) / PIXELS)) % 2;
      data.fill(
        (odd ? 105 : 170) + Math.round((85 * y) / PIXELS),
        (y * PIXELS + x) * 4,
        (y * PIXELS + x) * 4 + 3,
      );
    }
  texture = new THREE.DataTexture(data, PIXELS, PIXELS);
  Object.assign(texture, {
    colorSpace: THREE.SRGBColorSpace,
    generateMipmaps: true,
    minFilter: THREE.LinearMipmapLinearFilter,
    needsUpdate: true,
  });
  return texture;
}

const forward = new THREE.Vector3(0, 0, 1);
const direction = new THREE.Vector3();
const turn = new THREE.Quaternion();
const size = new THREE.Vector3();

/** Returns the matrix that puts the unit tetrahedron's base at `start` and its apex at `end`. */
export function place(out: THREE.Matrix4, start: THREE.Vector3, end: THREE.Vector3): THREE.Matrix4 {
  const length = direction.subVectors(end, start).length();
  if (length < 1e-9) return out.makeScale(0, 0, 0).setPosition(start);
  turn.setFromUnitVectors(forward, direction.divideScalar(length));
  return out.compose(start, turn, size.set(length * THICKNESS, length * THICKNESS, length));
}
