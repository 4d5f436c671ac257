/** Shows the skin with its materials (RD3), as wire, as both, as a ghost around the bones, or not at all. */

import * as THREE from "three";
import { type Body, materialsOf } from "./bodies";
import { CrowdMesh } from "./crowdMesh";

export interface SkinLook {
  skin: boolean;
  wire: boolean;
  /** The skin is translucent, for the bones inside. */
  ghost: boolean;
}

interface Own {
  transparent: boolean;
  opacity: number;
  depthWrite: boolean;
}

const GHOST_OPACITY = 0.32;
const owns = new WeakMap<THREE.Material, Own>();

function shade(material: THREE.Material, look: SkinLook): void {
  const own = owns.get(material) ?? {
    transparent: material.transparent,
    opacity: material.opacity,
    depthWrite: material.depthWrite,
  };
  owns.set(material, own);
  const transparent = look.ghost || own.transparent;
  if (material.transparent !== transparent) material.needsUpdate = true;
  // The offset keeps the skin from covering the lines.
  Object.assign(material, { polygonOffset: look.wire, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
  material.visible = look.skin;
  material.transparent = transparent;
  material.opacity = look.ghost ? own.opacity * GHOST_OPACITY : own.opacity;
  material.depthWrite = look.ghost ? true : own.depthWrite;
}

const wireMaterial = new THREE.MeshBasicMaterial({ wireframe: true, transparent: true, opacity: 0.55 });
const wires = new WeakMap<THREE.Mesh, THREE.Mesh>();

export function wireColour(ink: string): void {
  wireMaterial.color.set(ink);
}

/** Returns a wire copy of `mesh`, which moves as it does. */
function wireOf(mesh: THREE.Mesh): THREE.Mesh {
  const made = wires.get(mesh);
  if (made) return made;
  const twin =
    mesh instanceof CrowdMesh
      ? mesh.twin(mesh.geometry, wireMaterial)
      : new THREE.Mesh(mesh.geometry, wireMaterial);
  twin.frustumCulled = false;
  twin.renderOrder = 2;
  mesh.add(twin);
  wires.set(mesh, twin);
  return twin;
}

export function showSkin(meshes: readonly Body[], look: SkinLook): void {
  for (const mesh of meshes) {
    for (const material of materialsOf(mesh)) shade(material, look);
    mesh.castShadow = mesh.receiveShadow && look.skin;
    if (!(mesh instanceof THREE.Mesh)) continue;
    // The geometry changes with the way of skinning.
    if (look.wire || wires.has(mesh))
      Object.assign(wireOf(mesh), { visible: look.wire, geometry: mesh.geometry });
  }
}
