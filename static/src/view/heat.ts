/** Paints the weights of a bone over a skin: blue is none, red is all. */

import * as THREE from "three";
import type { Body } from "./bodies";

const VERTEX = "attribute float heat;\nvarying float vHeat;\n";
const FRAGMENT = /* glsl */ `
  varying float vHeat;
  vec3 heatColour(float share) {
    vec3 cold = mix(vec3(0.05, 0.09, 0.35), vec3(0.0, 0.45, 0.55), smoothstep(0.0, 0.33, share));
    vec3 warm = mix(cold, vec3(0.85, 0.75, 0.05), smoothstep(0.33, 0.66, share));
    return mix(warm, vec3(0.75, 0.02, 0.0), smoothstep(0.66, 1.0, share));
  }
`;

/** The material of all bodies whose weights are shown. */
export const heatMaterial = new THREE.MeshLambertMaterial({ toneMapped: false });
heatMaterial.onBeforeCompile = (shader) => {
  shader.vertexShader =
    VERTEX + shader.vertexShader.replace("#include <begin_vertex>", "#include <begin_vertex>\nvHeat = heat;");
  shader.fragmentShader =
    FRAGMENT +
    shader.fragmentShader.replace(
      "#include <color_fragment>",
      "#include <color_fragment>\ndiffuseColor.rgb = heatColour(vHeat);",
    );
};

/**
 * Returns the share (V) of each vertex that a joint moves, 0…1; `moves` says which of the matrices that
 * vertices follow are the joint's.
 */
export function weightsOf(
  { attributes }: THREE.BufferGeometry,
  moves: (follow: number) => boolean,
): Float32Array {
  const shares = new Float32Array(attributes["position"]?.count ?? 0);
  for (const [joints, weights] of [
    [attributes["skinIndex"], attributes["skinWeight"]],
    [attributes["moreJoints"], attributes["moreWeights"]],
  ])
    for (let i = 0; joints && weights && i < shares.length; i++)
      for (let k = 0; k < 4; k++)
        if (moves(joints.getComponent(i, k))) shares[i]! += weights.getComponent(i, k);
  return shares;
}

/** Gives a body the numbers to show, one for each vertex: weights, or what `name` says. */
export function heat(body: Body, shares: Float32Array, name = "heat"): void {
  const known = body.geometry.getAttribute(name) as THREE.BufferAttribute | undefined;
  if (known?.count !== shares.length)
    body.geometry.setAttribute(name, new THREE.BufferAttribute(shares.slice(), 1));
  else Object.assign(known, { needsUpdate: true }).copyArray(shares);
}
