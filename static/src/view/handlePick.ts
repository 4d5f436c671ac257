/** Finds the handle that a press takes hold of: a hand may miss a small ball, above all one that moves. */

import * as THREE from "three";
import { pixelsPerMetre } from "./detailChoice";

/** Pixels of the page that a press may be away from the middle of a handle: of a mouse, and of a finger. */
const [MOUSE, FINGER] = [12, 22];

/** A handle as it is drawn, in pixels of the page. */
interface Disc {
  x: number;
  y: number;
  radius: number;
}

/** Metres of a pixel of a picture `height_px` high, at a place. */
export function metresOfPixel(
  camera: THREE.PerspectiveCamera,
  height_px: number,
  place: THREE.Vector3,
): number {
  const height = Math.max(camera.view?.fullHeight ?? height_px, 1);
  return 1 / pixelsPerMetre(camera.position.distanceTo(place), camera.fov / camera.zoom, height);
}

/** Returns the balls, by name, as they are drawn; those behind the camera are not. */
export function drawnDiscs(
  balls: Iterable<readonly [string, THREE.Object3D]>,
  camera: THREE.PerspectiveCamera,
  canvas: HTMLCanvasElement,
): Map<string, Disc> {
  const { left, top, width, height } = canvas.getBoundingClientRect();
  const discs = new Map<string, Disc>();
  for (const [name, { position, scale }] of balls) {
    const { x, y, z } = position.clone().project(camera);
    if (z > 1) continue;
    const radius = scale.x / metresOfPixel(camera, height, position);
    discs.set(name, { x: left + ((x + 1) / 2) * width, y: top + ((1 - y) / 2) * height, radius });
  }
  return discs;
}

/** Returns the name of the handle nearest to a press that is on it or just beside it; null: there is none. */
export function handleAt(
  discs: ReadonlyMap<string, Disc>,
  press: Pick<PointerEvent, "clientX" | "clientY" | "pointerType">,
): string | null {
  const reach = press.pointerType === "touch" ? FINGER : MOUSE;
  let [found, least]: [string | null, number] = [null, Infinity];
  for (const [name, { x, y, radius }] of discs) {
    const away = Math.hypot(press.clientX - x, press.clientY - y);
    if (away <= Math.max(radius, reach) && away < least) [found, least] = [name, away];
  }
  return found;
}
