/** The light of a picture: the sky, one lamp before the character and one behind it. */

import * as THREE from "three";

const SHADOW_PIXELS = 2048;

export class Lights {
  readonly sky = new THREE.HemisphereLight(0xe8f0ff, 0x6b6157, 2.1);
  private readonly key = new THREE.DirectionalLight(0xfff3e6, 2.8);
  private readonly rim = new THREE.DirectionalLight(0xbcd2ff, 0.9);
  private height = 1.8;

  constructor(world: THREE.Scene) {
    world.add(this.sky, this.key, this.key.target, this.rim, this.rim.target);
  }

  /** Lets the lamp before the character cast shadows, or no longer. */
  castShadows(on: boolean): void {
    this.key.castShadow = on;
    this.key.shadow.mapSize.set(SHADOW_PIXELS, SHADOW_PIXELS);
    this.key.shadow.radius = 5;
    this.key.shadow.bias = -0.0004;
    this.key.shadow.normalBias = 0.02;
  }

  /** Fits lamps and shadow to a character `height_m` tall. */
  fit(height_m: number): void {
    this.height = height_m;
    const camera = this.key.shadow.camera;
    Object.assign(camera, {
      left: -2 * height_m,
      right: 2 * height_m,
      top: 2 * height_m,
      bottom: -2 * height_m,
      near: 0.1 * height_m,
      far: 9 * height_m,
    });
    camera.updateProjectionMatrix();
  }

  /** Moves the lamps with the character at `position`. */
  follow(position: THREE.Vector3): void {
    this.place(this.key, position, [1.6, 3.2, 2.0]);
    this.place(this.rim, position, [-1.8, 2.2, -2.4]);
  }

  private place(
    light: THREE.DirectionalLight,
    position: THREE.Vector3,
    [x, y, z]: [number, number, number],
  ): void {
    light.target.position.set(position.x, position.y + 0.5 * this.height, position.z);
    light.position.copy(position).add(new THREE.Vector3(x, y, z).multiplyScalar(this.height));
  }
}
