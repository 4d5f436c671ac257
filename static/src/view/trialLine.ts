/** Draws where the joints of a chain would be: a line with a dot at each joint. */

import * as THREE from "three";

const MOST = 256;

export class TrialLine {
  readonly object = new THREE.Group();
  private readonly places = new Float32Array(MOST * 3);
  private readonly geometry = new THREE.BufferGeometry();

  constructor() {
    this.geometry.setAttribute("position", new THREE.BufferAttribute(this.places, 3));
    const look = { color: "#2f86eb", depthTest: false, transparent: true };
    const line = new THREE.Line(this.geometry, new THREE.LineBasicMaterial(look));
    const dots = new THREE.Points(
      this.geometry,
      new THREE.PointsMaterial({ ...look, size: 8, sizeAttenuation: false }),
    );
    for (const drawn of [line, dots]) Object.assign(drawn, { frustumCulled: false, renderOrder: 18 });
    this.object.add(line, dots);
    this.show([]);
  }

  /** Shows a line through these places, metres; none: no line. */
  show(places: readonly THREE.Vector3[]): void {
    places.slice(0, MOST).forEach((place, k) => place.toArray(this.places, 3 * k));
    this.geometry.setDrawRange(0, Math.min(places.length, MOST));
    this.geometry.getAttribute("position").needsUpdate = true;
  }
}
