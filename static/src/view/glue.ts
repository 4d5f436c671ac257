/** Paints the glue triangles of a skin: triangles whose corners follow different bones (FAQ Q20). */

import * as THREE from "three";
import { heaviestBone, sharesOf } from "./skinWays";

/** The attribute that holds the bone of each vertex. */
export const GLUE = "bone";
const VERTEX = `attribute float ${GLUE};\nvarying float vBone;\n`;
const FRAGMENT = /* glsl */ `
  varying float vBone;
  const vec3 glueColour = vec3(0.9, 0.16, 0.02);
  /** A pale colour of its own for each bone. */
  vec3 boneColour(float bone) {
    vec3 hue = 0.5 + 0.5 * cos(6.2831853 * (bone * 0.381966 + 0.45 + vec3(0.0, 0.33, 0.67)));
    return mix(vec3(0.55), hue, 0.35);
  }
`;

/**
 * The material of all bodies whose glue is shown. Where the corners of a triangle follow one bone, its number is
 * the same over the whole triangle; on a glue triangle it changes from pixel to pixel.
 */
export const glueMaterial = new THREE.MeshLambertMaterial({ toneMapped: false });
glueMaterial.onBeforeCompile = (shader) => {
  shader.vertexShader =
    VERTEX +
    shader.vertexShader.replace("#include <begin_vertex>", `#include <begin_vertex>\nvBone = ${GLUE};`);
  shader.fragmentShader =
    FRAGMENT +
    shader.fragmentShader.replace(
      "#include <color_fragment>",
      "#include <color_fragment>\ndiffuseColor.rgb = fwidth(vBone) > 1e-4 ? glueColour : boneColour(round(vBone));",
    );
};

/** Returns the bone (V) that each vertex follows: the heaviest of its skin. */
export function bonesOf(geometry: THREE.BufferGeometry): Float32Array {
  const bones = new Float32Array(geometry.getAttribute("position").count);
  if (!geometry.hasAttribute("skinIndex")) return bones;
  return bones.map((_, vertex) => heaviestBone(sharesOf(geometry, [vertex])));
}
