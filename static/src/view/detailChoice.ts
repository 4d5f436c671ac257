/** Chooses a level of detail: by the size on screen, or by hand. */

import * as THREE from "three";
import { signal } from "@preact/signals-core";
import type { DetailLevel } from "./collapses";

/** The largest error on screen. */
export const MOST_PIXELS = 1;
/** By size a crowd draws every second level: each level that is in use costs draw calls. */
const STRIDE = 2;

/** Returns the pixels of a metre at a distance from the camera, in a picture of `height_px`. */
export function pixelsPerMetre(distance_m: number, fov_deg: number, height_px: number): number {
  const seen_m = 2 * Math.max(1e-6, distance_m) * Math.tan(THREE.MathUtils.degToRad(fov_deg) / 2);
  return height_px / seen_m;
}

/** Returns the coarsest level, 0 for the full skin, whose error is at most MOST_PIXELS on screen. */
export function levelBySize(levels: readonly DetailLevel[], pixels_per_m: number, stride = STRIDE): number {
  let level = 0;
  for (let k = stride; k <= levels.length; k += stride)
    if (levels[k - 1]!.error_m * pixels_per_m <= MOST_PIXELS) level = k;
  return level;
}

export class DetailChoice {
  /** The level that is drawn, 0 for the full skin; null: by the size on screen. */
  readonly byHand = signal<number | null>(null);

  /** Returns the level of an actor at a distance from the camera, metres. */
  levelAt(
    levels: readonly DetailLevel[],
    distance_m: number,
    camera: THREE.PerspectiveCamera,
    height_px: number,
  ): number {
    if (this.byHand.value !== null) return Math.min(this.byHand.value, levels.length);
    return levelBySize(levels, pixelsPerMetre(distance_m, camera.fov / camera.zoom, height_px));
  }
}
