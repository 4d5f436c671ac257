/**
 * Shows the watched actor through what stands before it: walls, ground and actors of other casts fade where they
 * cover it. They are drawn with holes, in a pattern, so that nothing has to be sorted.
 */

import * as THREE from "three";
import { type Body, materialsOf } from "./bodies";

/** The sphere that stays in sight, in the space of the camera; radius 0: nothing fades. */
const seen = { centre: new THREE.Vector3(), radius: 0 };

/** What is nearer to the actor's middle than this share of its radius may belong to it. */
const NEAR = 0.8;
const MOST_CUT = 0.85;

const DECLARED = /* glsl */ `
#ifdef CUT_AWAY
  struct Seen { vec3 centre; float radius; };
  uniform Seen seen;

  // Interleaved gradient noise: Jimenez, Next Generation Post Processing in Call of Duty, 2014.
  float pattern( const in vec2 pixel ) {
    return fract( 52.9829189 * fract( dot( pixel, vec2( 0.06711056, 0.00583715 ) ) ) );
  }
  bool isCutAway( const in vec3 at ) {
    float far = length( seen.centre );
    vec3 axis = seen.centre / max( far, 1e-6 );
    float along = dot( at, axis );
    if ( seen.radius <= 0.0 || along > far - ${NEAR.toFixed(2)} * seen.radius ) return false;
    float aside = length( at - along * axis ) * far / max( along, 1e-6 );
    float cut = 1.0 - smoothstep( 0.9, 1.3, aside / seen.radius );
    return pattern( gl_FragCoord.xy ) < ${MOST_CUT.toFixed(2)} * cut;
  }
#endif
`;

const CUT = /* glsl */ `
#ifdef CUT_AWAY
  if ( isCutAway( - vViewPosition ) ) discard;
#endif
`;

/** Makes the materials of walls able to fade; call it before anything is drawn. */
export function teachCutaway(): void {
  const { physical } = THREE.ShaderLib;
  physical.uniforms["seen"] = { value: seen };
  physical.fragmentShader = physical.fragmentShader
    .replace("#include <clipping_planes_pars_fragment>", `$&\n${DECLARED}`)
    .replace("#include <clipping_planes_fragment>", `$&\n${CUT}`);
}

/** Lets what these bodies are drawn with fade before the watched actor, or no longer. */
export function fade(bodies: readonly Body[], on: boolean): void {
  for (const material of bodies.flatMap(materialsOf)) {
    if (!(material instanceof THREE.MeshStandardMaterial)) continue;
    const { CUT_AWAY, ...others } = material.defines as Record<string, string>;
    if ((CUT_AWAY !== undefined) === on) continue;
    material.defines = on ? { ...others, CUT_AWAY: "" } : others;
    material.needsUpdate = true;
  }
}

/** Keeps a sphere of the stage in sight of a camera until the next call; null: none. */
export function keepInSight(body: THREE.Sphere | null, camera: THREE.Camera): void {
  seen.radius = body?.radius ?? 0;
  if (body) seen.centre.copy(body.center).applyMatrix4(camera.matrixWorldInverse);
}
