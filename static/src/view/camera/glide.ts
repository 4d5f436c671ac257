/** A glide: the camera comes near what it looks at, or goes away from it, without haste and without turning. */

import * as THREE from "three";

/** Time constant, seconds. */
const GLIDE_S = 0.3;
/** A glide ends that is as near, in metres and in the logarithm of the distance. */
const ARRIVED = 1e-4;

/** What a camera looks at, and the camera. */
export interface Controls {
  readonly object: THREE.Camera;
  readonly target: THREE.Vector3;
}

export class Glide {
  private readonly way: THREE.Vector3;
  private zoom: number;

  /** Leads to a `target`, at a `distance` from it. */
  constructor(
    private readonly controls: Controls,
    target: THREE.Vector3,
    distance: number,
  ) {
    this.way = target.clone().sub(controls.target);
    this.zoom = distance / this.away.length();
  }

  private get away(): THREE.Vector3 {
    return this.controls.object.position.clone().sub(this.controls.target);
  }

  /** Makes the way of `dt` seconds; returns whether the camera has arrived. */
  go(dt: number): boolean {
    const share = 1 - Math.exp(-dt / GLIDE_S);
    const step = this.way.clone().multiplyScalar(share);
    const away = this.away.multiplyScalar(this.zoom ** share);
    this.way.sub(step);
    this.zoom **= 1 - share;
    this.controls.object.position.copy(this.controls.target.add(step)).add(away);
    return this.way.length() + Math.abs(Math.log(this.zoom)) < ARRIVED;
  }
}
