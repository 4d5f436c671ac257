/** Draws the characters without ground, overlays and handles, into a target that nobody sees. */

import * as THREE from "three";

/** Draws `bodies` of the world; `material`: in place of theirs. */
export function drawAlone(
  renderer: THREE.WebGLRenderer,
  world: THREE.Scene,
  camera: THREE.Camera,
  bodies: readonly THREE.Object3D[],
  target: THREE.WebGLRenderTarget,
  material: THREE.Material | null = null,
): void {
  const kept = new Set(bodies);
  const others = world.children.filter(
    (child) => !kept.has(child) && child.visible && !(child instanceof THREE.Light),
  );
  for (const other of others) other.visible = false;
  world.overrideMaterial = material;
  renderer.setRenderTarget(target);
  renderer.clear();
  renderer.render(world, camera);
  renderer.setRenderTarget(null);
  world.overrideMaterial = null;
  for (const other of others) other.visible = true;
}
