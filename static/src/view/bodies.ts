/** What a model is drawn with: triangles, and glTF's lines and points, which need a colour and a size. */

import * as THREE from "three";

export type Body = THREE.Mesh | THREE.Line | THREE.Points;

/** glTF says one pixel, which nobody sees on today's screens. */
const POINT_PIXELS = 5;

export const isBody = (object: THREE.Object3D): object is Body =>
  object instanceof THREE.Mesh || object instanceof THREE.Line || object instanceof THREE.Points;

/** Whether a body is drawn as lines or points. */
export const isStroke = (object: THREE.Object3D): object is THREE.Line | THREE.Points =>
  object instanceof THREE.Line || object instanceof THREE.Points;

export function materialsOf(body: Body): THREE.Material[] {
  return Array.isArray(body.material) ? body.material : [body.material];
}

const lineInk = new THREE.LineBasicMaterial();
const pointInk = new THREE.PointsMaterial({ size: POINT_PIXELS, sizeAttenuation: false });

/** Colours the lines and points that have no material: glTF's default white is invisible on a light ground. */
export function inkColour(ink: string): void {
  for (const { color } of [lineInk, pointInk]) color.set(ink);
}

/** Gives loaded lines and points their size; without a material of the file, `plain`, also their colour. */
export function dressStroke(body: THREE.Line | THREE.Points, plain: boolean): void {
  const coloured = body.geometry.hasAttribute("color");
  if (plain && !coloured) body.material = body instanceof THREE.Points ? pointInk : lineInk;
  for (const material of materialsOf(body))
    if (material instanceof THREE.PointsMaterial) material.size = POINT_PIXELS;
}

/** Makes the lines or points of a glTF primitive; `mode` is 0 points, 1 lines, 2 loop or 3 strip. */
export function stroke(
  geometry: THREE.BufferGeometry,
  mode: number,
  material: THREE.Material | undefined,
): THREE.Line | THREE.Points {
  const own = material as THREE.MeshStandardMaterial | undefined;
  const vertexColors = geometry.hasAttribute("color");
  const facts = { color: own?.color ?? 0xffffff, map: own?.map ?? null, vertexColors };
  const made =
    mode === 0
      ? new THREE.Points(geometry, new THREE.PointsMaterial({ ...facts, sizeAttenuation: false }))
      : new [THREE.LineSegments, THREE.LineLoop, THREE.Line][mode - 1]!(
          geometry,
          new THREE.LineBasicMaterial(facts),
        );
  dressStroke(made, !material);
  return made;
}
