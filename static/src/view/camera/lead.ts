/** A lead: the camera goes to where another page's camera stands while it waits for that page's next camera. */

import * as THREE from "three";
import type { Controls } from "./glide";

/** Seconds between two cameras of another page that moves its camera, and a little more. */
const LEAD_S = 0.14;

export class Lead {
  private readonly ways: readonly [THREE.Vector3, THREE.Vector3];
  private left = LEAD_S;

  /** Leads to `place`: where the other camera stands and what it looks at, metres from `origin`. */
  constructor(
    private readonly controls: Controls,
    place: readonly number[],
    origin: Readonly<THREE.Vector3>,
  ) {
    const [position, target] = [0, 3].map((at) => new THREE.Vector3().fromArray(place, at).add(origin));
    this.ways = [position!.sub(controls.object.position), target!.sub(controls.target)];
  }

  /** Makes the way of `dt` seconds; returns whether the camera has arrived. */
  go(dt: number): boolean {
    const share = dt < this.left ? dt / this.left : 1;
    const places = [this.controls.object.position, this.controls.target];
    this.ways.forEach((way, k) => {
      const step = way.clone().multiplyScalar(share);
      way.sub(step);
      places[k]!.add(step);
    });
    this.left -= dt;
    return share === 1;
  }
}
