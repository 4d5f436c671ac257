/** Draws the arc that a joint takes through the stage: a line through its latest places, a dot at each frame. */

import * as THREE from "three";

export const MOST_PLACES = 240;
/** Frames further apart than this are not joined. */
const MOST_TICKS = 30;

export class MotionPath {
  readonly object = new THREE.Group();
  private readonly places = new Float32Array(MOST_PLACES * 3);
  private readonly geometry = new THREE.BufferGeometry();
  private readonly line = new THREE.LineBasicMaterial({ depthTest: false, transparent: true });
  private readonly dots = new THREE.PointsMaterial({
    size: 4,
    sizeAttenuation: false,
    depthTest: false,
    transparent: true,
  });
  private followed = "";
  private tick = -1;
  count = 0;

  constructor() {
    this.geometry.setAttribute("position", new THREE.BufferAttribute(this.places, 3));
    for (const drawn of [
      new THREE.Line(this.geometry, this.line),
      new THREE.Points(this.geometry, this.dots),
    ]) {
      drawn.frustumCulled = false;
      drawn.renderOrder = 10;
      this.object.add(drawn);
    }
  }

  /**
   * Adds the place (x, y, z, metres) at a tick of what `key` names; another key and a jump in time begin a new
   * path.
   */
  add(key: string, tick: number, place: readonly [number, number, number]): void {
    if (key !== this.followed || tick < this.tick || tick > this.tick + MOST_TICKS) this.clear();
    if (tick === this.tick) return;
    Object.assign(this, { followed: key, tick });
    if (this.count === MOST_PLACES) {
      this.places.copyWithin(0, 3);
      this.count -= 1;
    }
    this.places.set(place, this.count * 3);
    this.count += 1;
    this.geometry.setDrawRange(0, this.count);
    this.geometry.getAttribute("position").needsUpdate = true;
  }

  clear(): void {
    this.count = 0;
    this.followed = "";
    this.tick = -1;
    this.geometry.setDrawRange(0, 0);
  }

  /** Returns the places so far, oldest first. */
  get points(): number[][] {
    return Array.from({ length: this.count }, (_, row) => [...this.places.subarray(3 * row, 3 * row + 3)]);
  }

  colour(colour: string): void {
    this.line.color.set(colour);
    this.dots.color.set(colour);
  }
}
