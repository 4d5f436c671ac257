/** Draws the ground: a grid that follows the character and fades with distance. */

import * as THREE from "three";
import type { Quality } from "./quality";

const REACH_M = 14;

const VERTEX = /* glsl */ `
  varying vec2 ground;
  void main() {
    vec4 world = modelMatrix * vec4(position, 1.0);
    ground = world.xz;
    gl_Position = projectionMatrix * viewMatrix * world;
  }`;

const FRAGMENT = /* glsl */ `
  varying vec2 ground;
  uniform vec3 ink;
  uniform vec2 centre;
  uniform float unit;
  uniform float strength;
  float lines(float spacing) {
    vec2 at = ground / spacing;
    vec2 width = fwidth(at);
    vec2 away = abs(fract(at - 0.5) - 0.5) / max(width, vec2(1e-5));
    float line = 1.0 - min(min(away.x, away.y), 1.0);
    return line * (1.0 - smoothstep(0.25, 0.7, max(width.x, width.y)));
  }
  void main() {
    float far = length(ground - centre) / (unit * ${REACH_M.toFixed(1)});
    float fade = pow(max(0.0, 1.0 - far), 2.2);
    float ink_here = lines(unit) * 0.8 + lines(unit * 0.25) * 0.28;
    gl_FragColor = vec4(ink, ink_here * fade * strength);
    if (gl_FragColor.a < 0.004) discard;
    #include <colorspace_fragment>
  }`;

const LINE_FRAGMENT = /* glsl */ `
  varying vec2 ground;
  uniform vec3 ink;
  uniform vec2 centre;
  uniform float unit;
  uniform float strength;
  void main() {
    float far = length(ground - centre) / (unit * ${REACH_M.toFixed(1)});
    gl_FragColor = vec4(ink, 0.6 * pow(max(0.0, 1.0 - far), 2.2) * strength);
    #include <colorspace_fragment>
  }`;

/**
 * Makes lines half a unit apart: software rendering shades only their pixels, not the whole floor.
 * The lines are in pieces, because a line that passes the camera is dropped as a whole.
 */
function lineGeometry(): THREE.BufferGeometry {
  const corners: number[] = [];
  for (let i = -REACH_M; i <= REACH_M; i += 0.5) {
    for (let k = -REACH_M; k < REACH_M; k++) corners.push(i, 0, k, i, 0, k + 1, k, 0, i, k + 1, 0, i);
  }
  return new THREE.BufferGeometry().setAttribute("position", new THREE.Float32BufferAttribute(corners, 3));
}

function gridMaterial(fragmentShader: string): THREE.ShaderMaterial {
  const uniforms = {
    ink: { value: new THREE.Color() },
    centre: { value: new THREE.Vector2() },
    unit: { value: 1 },
    strength: { value: 1 },
  };
  return new THREE.ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader,
    transparent: true,
    depthWrite: false,
    side: THREE.DoubleSide,
    uniforms,
  });
}

export class Ground {
  readonly mesh:
    | THREE.Mesh<THREE.BufferGeometry, THREE.ShaderMaterial>
    | THREE.LineSegments<THREE.BufferGeometry, THREE.ShaderMaterial>;
  private unit = 1;

  constructor(private readonly quality: Quality) {
    const disc = (): THREE.BufferGeometry => new THREE.CircleGeometry(REACH_M, 48).rotateX(-Math.PI / 2);
    this.mesh =
      quality === "high"
        ? new THREE.Mesh(disc(), gridMaterial(FRAGMENT))
        : new THREE.LineSegments(lineGeometry(), gridMaterial(LINE_FRAGMENT));
    this.mesh.renderOrder = -2;
    this.mesh.frustumCulled = false;
  }

  /** Sets the grid's cell to the power of ten, in metres, that suits a character `height_m` tall. */
  fit(height_m: number): void {
    const unit = 10 ** Math.round(Math.log10(Math.max(height_m, 1e-3) / 1.8));
    this.unit = unit;
    this.mesh.scale.setScalar(unit);
    this.mesh.material.uniforms["unit"]!.value = unit;
  }

  follow(x: number, z: number): void {
    // The grid moves in whole units, so that its lines stay in place.
    const snap = (value: number): number =>
      this.quality === "high" ? value : Math.round(value / this.unit) * this.unit;
    this.mesh.position.set(snap(x), 0, snap(z));
    (this.mesh.material.uniforms["centre"]!.value as THREE.Vector2).set(x, z);
  }

  colour(ink: string, strength: number): void {
    (this.mesh.material.uniforms["ink"]!.value as THREE.Color).set(ink);
    this.mesh.material.uniforms["strength"]!.value = strength;
  }
}

/** Makes soft dark spots, the shadows of `count` characters in low quality. */
export function contactShadows(count: number): THREE.InstancedMesh {
  const material = new THREE.ShaderMaterial({
    transparent: true,
    depthWrite: false,
    vertexShader:
      "varying vec2 at; void main() { at = uv * 2.0 - 1.0; " +
      "gl_Position = projectionMatrix * modelViewMatrix * instanceMatrix * vec4(position, 1.0); }",
    fragmentShader:
      "varying vec2 at; void main() { float d = max(0.0, 1.0 - length(at)); " +
      "gl_FragColor = vec4(0.0, 0.0, 0.0, 0.42 * d * d); }",
  });
  const spots = new THREE.InstancedMesh(new THREE.PlaneGeometry(2, 2).rotateX(-Math.PI / 2), material, count);
  return Object.assign(spots, { renderOrder: -1, frustumCulled: false });
}
