/** Finds the actor at a pixel: draws this pixel alone, with the actors' ids as colours. */

import * as THREE from "three";
import { drawAlone } from "./bodiesAlone";

/** The id of a pixel that shows no actor. */
export const NOBODY = 0;

const material = new THREE.ShaderMaterial({
  side: THREE.DoubleSide,
  vertexShader: /* glsl */ `
    #include <common>
    #include <morphtarget_pars_vertex>
    #include <skinning_pars_vertex>
    attribute float actorId;
    flat varying float id;
    void main() {
      #include <skinbase_vertex>
      #include <begin_vertex>
      #include <morphtarget_vertex>
      #include <skinning_vertex>
      gl_Position = projectionMatrix * modelViewMatrix * vec4( transformed, 1.0 );
      gl_PointSize = 5.0;
      id = actorId;
    }`,
  fragmentShader: /* glsl */ `
    flat varying float id;
    void main() {
      int number = int( id );
      gl_FragColor = vec4( number & 255, ( number >> 8 ) & 255, ( number >> 16 ) & 255, 255 ) / 255.0;
    }`,
});

/** Returns a camera that sees only the pixel at `at`, -1…1, of a picture of `width` × `height` pixels. */
function pixelCamera(
  camera: THREE.PerspectiveCamera,
  at: THREE.Vector2,
  width: number,
  height: number,
): THREE.PerspectiveCamera {
  const pixel = new THREE.PerspectiveCamera().copy(camera, false);
  const enlarged = new THREE.Matrix4()
    .makeScale(width, height, 1)
    .setPosition(-at.x * width, -at.y * height, 0);
  pixel.projectionMatrix.copy(camera.projectionMatrix).premultiply(enlarged);
  pixel.projectionMatrixInverse.copy(pixel.projectionMatrix).invert();
  return pixel;
}

/** Returns the id of the actor that is drawn at `at`, -1…1; null: there is none. */
export function actorAt(
  renderer: THREE.WebGLRenderer,
  world: THREE.Scene,
  camera: THREE.PerspectiveCamera,
  bodies: readonly THREE.Object3D[],
  at: THREE.Vector2,
): number | null {
  const size = renderer.getSize(new THREE.Vector2());
  const target = new THREE.WebGLRenderTarget(1, 1);
  drawAlone(renderer, world, pixelCamera(camera, at, size.x, size.y), bodies, target, material);
  const colour = new Uint8Array(4);
  renderer.readRenderTargetPixels(target, 0, 0, 1, 1, colour);
  target.dispose();
  return colour[0]! + 256 * colour[1]! + 65536 * colour[2]! || null;
}
