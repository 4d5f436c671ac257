/** The cameras: what each does while the character moves, and from which side it looks. */

import * as THREE from "three";
import type { CameraMode } from "../../state/viewpoint";

/** Where a camera stands around what it looks at, radians. */
export interface Side {
  /** About +Y from the character's heading. */
  azimuth: number;
  /** Above the ground. */
  elevation: number;
}

/** Not quite from above: there left and right would be lost. */
const STEEP = Math.PI / 2 - 0.01;

const SIDES: Readonly<Record<CameraMode, Side | null>> = {
  follow: null,
  free: null,
  front: { azimuth: 0, elevation: 0.04 },
  side: { azimuth: Math.PI / 2, elevation: 0.04 },
  top: { azimuth: Math.PI, elevation: STEEP },
};

/** Returns the side from which a camera looks; null: the user chooses it. */
export const sideOf = (mode: CameraMode): Side | null => SIDES[mode];

/** Returns the unit vector from what is looked at to the camera; `heading`: radians about +Y, 0 is +Z. */
export function awayTo({ azimuth, elevation }: Side, heading: number): THREE.Vector3 {
  const turned = azimuth + heading;
  const flat = Math.cos(elevation);
  return new THREE.Vector3(Math.sin(turned) * flat, Math.sin(elevation), Math.cos(turned) * flat);
}

/** Returns the side of a camera that is `away` from what it looks at. */
export function sideFrom(away: THREE.Vector3, heading: number): Side {
  return {
    azimuth: Math.atan2(away.x, away.z) - heading,
    elevation: Math.atan2(away.y, Math.hypot(away.x, away.z)),
  };
}

/** Returns the shortest turn from one direction to another, radians, -π…π. */
export function turnTo(from: number, to: number): number {
  const turn = to - from;
  return turn - 2 * Math.PI * Math.round(turn / (2 * Math.PI));
}
