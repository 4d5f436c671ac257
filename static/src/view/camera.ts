/** Frames a character and follows it smoothly, at the angle and distance that the user has chosen. */

import * as THREE from "three";
import type { CameraAt } from "../net/protocol";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";

/** Time constant of the following, seconds. */
const LAG_S = 0.18;
/** A move of more than this many heights is a cut, as after a scrub. */
const CUT_HEIGHTS = 0.8;
/** Of the turntable. */
const SECONDS_PER_TURN = 12;
/** The share of the picture that controls may take from what is framed. */
const MOST_COVERED = 0.4;
const AZIMUTH = 0.52;
const ELEVATION = 0.14;
/** With several actors: from behind and above, so that you see what lies ahead. */
const COMPANY_AZIMUTH = Math.PI + 0.45;
const COMPANY_ELEVATION = 0.34;

const millimetres = ({ x, y, z }: THREE.Vector3): CameraAt["position"] => [
  Math.round(1000 * x) / 1000,
  Math.round(1000 * y) / 1000,
  Math.round(1000 * z) / 1000,
];

export class FollowCamera {
  readonly camera = new THREE.PerspectiveCamera(32, 1, 0.01, 500);
  readonly controls: OrbitControls;
  private readonly goal = new THREE.Vector3();
  private readonly followed = new THREE.Vector3();
  private readonly centre = new THREE.Vector3(0, 0.9, 0);
  private height = 1.8;
  private radius = 1;
  private heading = 0;

  constructor(
    element: HTMLElement,
    private readonly still: () => boolean,
  ) {
    this.controls = new OrbitControls(this.camera, element);
    this.controls.enableDamping = true;
    this.controls.dampingFactor = 0.12;
    this.controls.maxPolarAngle = Math.PI * 0.55;
    this.controls.autoRotateSpeed = 60 / SECONDS_PER_TURN;
  }

  /** Turns around the character, or stops. */
  turn(turning: boolean): void {
    this.controls.autoRotate = turning;
  }

  /** Sets the box to frame: the character around its root, metres. */
  subject(box: THREE.Box3): void {
    const size = box.getSize(new THREE.Vector3());
    box.getCenter(this.centre);
    this.height = Math.max(size.y, 1e-3);
    this.radius = Math.max(size.length() / 2, 1e-3);
    this.controls.minDistance = this.radius * 0.4;
    this.controls.maxDistance = this.radius * 14;
    this.camera.near = this.radius / 60;
    this.camera.far = this.radius * 80;
  }

  /**
   * Frames the whole character, from the front, a little from the side and from above; in `company` from
   * behind.
   */
  frame(company = false): void {
    this.followed.copy(this.goal);
    const target = this.controls.target.copy(this.goal).add(this.centre);
    const half = THREE.MathUtils.degToRad(this.camera.fov / 2);
    const narrow = Math.min(half, Math.atan(Math.tan(half) * this.camera.aspect));
    const distance = (this.radius / Math.sin(narrow)) * 1.14;
    const [azimuth, elevation] = company
      ? [COMPANY_AZIMUTH + this.heading, COMPANY_ELEVATION]
      : [AZIMUTH, ELEVATION];
    const away = new THREE.Vector3(
      Math.sin(azimuth) * Math.cos(elevation),
      Math.sin(elevation),
      Math.cos(azimuth) * Math.cos(elevation),
    );
    this.camera.position.copy(target).addScaledVector(away, distance);
    this.camera.updateProjectionMatrix();
    this.controls.update();
  }

  /** Sets the followed root's position and heading (radians about +Y, 0 is +Z). */
  aim(position: THREE.Vector3, heading = this.heading): void {
    this.goal.copy(position);
    this.heading = heading;
  }

  /** Where the camera stands and what it looks at, to a millimetre. */
  get place(): CameraAt {
    return { position: millimetres(this.camera.position), target: millimetres(this.controls.target) };
  }

  /** Stands where another camera stands; from there it goes on with the character. */
  stand({ position, target }: CameraAt): void {
    this.followed.copy(this.goal);
    this.camera.position.fromArray(position);
    this.controls.target.fromArray(target);
    this.controls.update();
  }

  /** Where the camera stands and what it looks at, from the followed root, metres. */
  get around(): number[] {
    return [this.camera.position, this.controls.target].flatMap((place) =>
      place.clone().sub(this.followed).toArray(),
    );
  }

  /** Stands around the followed root, as another page did. */
  standAround(around: readonly number[]): void {
    this.camera.position.fromArray(around).add(this.followed);
    this.controls.target.fromArray(around, 3).add(this.followed);
    this.controls.update();
  }

  /** Moves by `dt` seconds; returns whether the view changed. */
  update(dt: number): boolean {
    const way = this.goal.distanceTo(this.followed);
    const cut = way > this.height * CUT_HEIGHTS || this.still();
    const step = this.goal
      .clone()
      .sub(this.followed)
      .multiplyScalar(cut ? 1 : 1 - Math.exp(-dt / LAG_S));
    if (way > 1e-5) {
      this.followed.add(step);
      this.controls.target.add(step);
      this.camera.position.add(step);
    }
    return this.controls.update(dt) || way > 1e-5;
  }

  /** Fits a picture of `width` × `height` pixels; what is framed stays above the lowest `covered` pixels. */
  resize(width: number, height: number, covered = 0): void {
    const free = Math.max(height - Math.min(covered, MOST_COVERED * height), 1);
    this.camera.aspect = width / free;
    this.camera.setViewOffset(width, free, 0, 0, width, height);
  }
}
