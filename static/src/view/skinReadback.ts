/**
 * Reads back where the GPU puts the vertices of an actor: each vertex draws its place in the stage as the colour
 * of a pixel of its own, with the shader code that skins it in the picture.
 */

import * as THREE from "three";
import type { Crowd } from "./crowd";
import { CrowdGeometry, Roster, bodyOf } from "./crowdMesh";
import type { Part } from "./crowdParts";
import { geometryIn } from "./skinWays";

const WIDTH = 256;

const material = new THREE.ShaderMaterial({
  depthTest: false,
  uniforms: { height: { value: 1 } },
  vertexShader: /* glsl */ `
    #include <common>
    #include <morphtarget_pars_vertex>
    #include <skinning_pars_vertex>
    uniform float height;
    varying vec3 place;
    void main() {
      #include <skinbase_vertex>
      #include <begin_vertex>
      #include <morphtarget_vertex>
      #include <skinning_vertex>
      place = transformed;
      vec2 pixel = vec2( gl_VertexID % ${WIDTH}, gl_VertexID / ${WIDTH} ) + 0.5;
      gl_Position = vec4( 2.0 * pixel / vec2( ${WIDTH}.0, height ) - 1.0, 0.0, 1.0 );
      gl_PointSize = 1.0;
    }`,
  fragmentShader: /* glsl */ `
    varying vec3 place;
    void main() {
      gl_FragColor = vec4( place, 1.0 );
    }`,
});

/** Returns (V, 4) x y z 1 of the vertices of a part of an actor, as the GPU poses them, metres. */
export function readVertices(
  renderer: THREE.WebGLRenderer,
  crowd: Crowd,
  row: number,
  part: Part,
): Float32Array {
  const shaped = geometryIn(part.geometry, crowd.way, part.like instanceof THREE.Mesh);
  const roster = new Roster(
    crowd.cast.actors.map(({ id }) => id),
    crowd.texture,
  );
  roster.take([row]);
  const geometry = new CrowdGeometry(roster).share(shaped, null);
  const points = bodyOf({ ...part, like: new THREE.Points(), material }, geometry, crowd.texture);
  const height = Math.ceil(shaped.getAttribute("position").count / WIDTH);
  material.uniforms["height"]!.value = height;
  const target = new THREE.WebGLRenderTarget(WIDTH, height, { type: THREE.FloatType });
  const places = new Float32Array(WIDTH * height * 4);
  renderer.setRenderTarget(target);
  renderer.clear();
  renderer.render(new THREE.Scene().add(points), new THREE.Camera());
  renderer.readRenderTargetPixels(target, 0, 0, WIDTH, height, places);
  renderer.setRenderTarget(null);
  target.dispose();
  geometry.dispose();
  return places;
}
