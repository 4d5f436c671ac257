/**
 * Frames a character and follows it smoothly, at the angle and distance that the user has chosen, or from the side
 * of its mode.
 */

import * as THREE from "three";
import { signal } from "@preact/signals-core";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { CameraMode } from "../../state/viewpoint";
import { awayTo, type Side, sideFrom, sideOf, turnTo } from "./cameraModes";
import { Glide } from "./glide";
import { Lead } from "./lead";

/** Time constant of the following, seconds. */
const LAG_S = 0.18;
/** Time constant of the swing after a drag, seconds. */
const SWING_S = 0.13;
/** A move of more than this many heights is a cut, as after a scrub. */
const CUT_HEIGHTS = 0.8;
/** Of the turntable. */
const SECONDS_PER_TURN = 12;
/** The shares of the picture's height and width that may be taken from what is framed. */
const [MOST_BELOW, MOST_RIGHT] = [0.4, 0.6];
const ALONE: Side = { azimuth: 0.52, elevation: 0.14 };
/** With several actors: from behind and above, so that you see what lies ahead. */
const COMPANY: Side = { azimuth: Math.PI + 0.45, elevation: 0.34 };
/** A drag that turns the camera by more, radians, leaves the side of its mode. */
const LEAVES_SIDE = 0.03;

export class FollowCamera {
  readonly camera = new THREE.PerspectiveCamera(32, 1, 0.01, 500);
  readonly controls: OrbitControls;
  readonly mode = signal<CameraMode>("follow");
  private readonly goal = new THREE.Vector3();
  private readonly followed = new THREE.Vector3();
  private readonly centre = new THREE.Vector3(0, 0.9, 0);
  private height = 1.8;
  private radius = 1;
  private heading = 0;
  private dragging = false;
  /** On its way by itself. */
  private going: Glide | Lead | null = null;

  constructor(
    element: HTMLElement,
    private readonly still: () => boolean,
  ) {
    this.controls = new OrbitControls(this.camera, element);
    this.controls.enableDamping = true;
    this.controls.maxPolarAngle = Math.PI * 0.55;
    this.controls.autoRotateSpeed = 60 / SECONDS_PER_TURN;
    this.mode.subscribe((mode) => sideOf(mode) && this.centreBody());
    this.controls.addEventListener("start", () => {
      this.dragging = true;
      this.land();
    });
    this.controls.addEventListener("end", () => this.dragged());
  }

  /** A camera that was turned away from its side stays where it was put. */
  private dragged(): void {
    this.dragging = false;
    const side = sideOf(this.mode.value);
    if (!side) return;
    const now = sideFrom(this.away, this.heading);
    const turned = Math.hypot(turnTo(now.azimuth, side.azimuth), now.elevation - side.elevation);
    if (turned > LEAVES_SIDE) this.mode.value = "follow";
  }

  /** Moves the camera, without turning it, so that the character is in the middle. */
  private centreBody(): void {
    this.land();
    const way = this.goal.clone().add(this.centre).sub(this.controls.target);
    for (const place of [this.controls.target, this.camera.position]) place.add(way);
    this.followed.copy(this.goal);
  }

  /** From what the camera looks at to the camera, metres. */
  private get away(): THREE.Vector3 {
    return this.camera.position.clone().sub(this.controls.target);
  }

  /** Turns around the character, or stops. */
  turn(turning: boolean): void {
    if (turning && sideOf(this.mode.value)) this.mode.value = "follow";
    this.controls.autoRotate = turning;
  }

  /** Sets the box to frame: the character around its root, metres. */
  subject(box: THREE.Box3): void {
    const size = box.getSize(new THREE.Vector3());
    box.getCenter(this.centre);
    this.height = Math.max(size.y, 1e-3);
    this.radius = Math.max(size.length() / 2, 1e-3);
    this.camera.near = this.radius / 60;
    this.camera.far = this.radius * 80;
  }

  /**
   * Frames the whole character: from the side of the mode, else from the front, a little from the side and from
   * above; in `company` from behind.
   */
  frame(company = false): void {
    this.land();
    this.followed.copy(this.goal);
    const target = this.controls.target.copy(this.goal).add(this.centre);
    const side = sideOf(this.mode.value) ?? (company ? COMPANY : ALONE);
    const heading = side === ALONE ? 0 : this.heading;
    this.camera.position.copy(target).addScaledVector(awayTo(side, heading), this.distance);
    this.camera.updateProjectionMatrix();
    this.controls.update();
  }

  /** The distance at which the subject fills the picture. */
  private get distance(): number {
    const half = THREE.MathUtils.degToRad(this.camera.fov / 2);
    const narrow = Math.min(half, Math.atan(Math.tan(half) * this.camera.aspect));
    return (this.radius / Math.sin(narrow)) * 1.14;
  }

  /** Frames the subject without haste and from where it looks; a drag stops the camera where it is. */
  glide(): void {
    this.go(new Glide(this.controls, this.followed.clone().add(this.centre), this.distance));
  }

  private go(going: Glide | Lead): void {
    this.going = going;
    Object.assign(this.controls, { minDistance: 0, maxDistance: Infinity });
  }

  /** Ends a way where the camera is. */
  private land(): void {
    this.going = null;
    Object.assign(this.controls, { minDistance: this.radius * 0.4, maxDistance: this.radius * 14 });
  }

  /** Goes on; returns whether the camera is on a way. */
  private goOn(dt: number): boolean {
    if (!this.going) return false;
    if (this.going.go(this.still() ? Infinity : dt)) this.land();
    return true;
  }

  /** Whether the middle of the character is in the picture. */
  get sees(): boolean {
    this.camera.updateMatrixWorld();
    const { projectionMatrix, matrixWorldInverse } = this.camera;
    const seen = new THREE.Matrix4().multiplyMatrices(projectionMatrix, matrixWorldInverse);
    return new THREE.Frustum()
      .setFromProjectionMatrix(seen)
      .containsPoint(this.goal.clone().add(this.centre));
  }

  /** Sets the followed root's position and heading (radians about +Y, 0 is +Z). */
  aim(position: THREE.Vector3, heading = this.heading): void {
    this.goal.copy(position);
    this.heading = heading;
  }

  /** With what the camera moves: the followed root, or, if it is free, the stage. */
  private get origin(): Readonly<THREE.Vector3> {
    return this.mode.value === "free" ? new THREE.Vector3() : this.followed;
  }

  /** Where the camera stands and what it looks at, metres, from the followed root; of a free camera, on the stage. */
  get place(): number[] {
    return this.placeFrom(this.origin);
  }

  /** Goes to the `place` of another camera. */
  lead(place: readonly number[]): void {
    this.go(new Lead(this.controls, place, this.origin));
  }

  /** Where the camera stands and what it looks at, from the followed root, metres. */
  get around(): number[] {
    return this.placeFrom(this.followed);
  }

  private placeFrom(origin: Readonly<THREE.Vector3>): number[] {
    return [this.camera.position, this.controls.target].flatMap((place) =>
      place.clone().sub(origin).toArray(),
    );
  }

  /** Stands around the followed root, as another page did. */
  standAround(around: readonly number[]): void {
    this.land();
    this.camera.position.fromArray(around).add(this.followed);
    this.controls.target.fromArray(around, 3).add(this.followed);
    this.controls.update();
  }

  /** Moves by `dt` seconds; returns whether the view changed. */
  update(dt: number): boolean {
    const followed = this.follow(dt);
    const turned = this.keepSide(dt);
    const went = this.goOn(dt);
    // The controls take a share for each drawing: so that a drag swings as long however often the page draws.
    this.controls.dampingFactor = 1 - Math.exp(-dt / SWING_S);
    return this.controls.update(dt) || followed || turned || went;
  }

  /** Goes at once where it is on the way to. */
  catchUp(): void {
    this.follow(Infinity);
    this.keepSide(Infinity);
    this.goOn(Infinity);
    this.controls.update();
  }

  /** The share of a way that the camera makes in `dt` seconds. */
  private share(dt: number, cut: boolean): number {
    return cut || this.still() ? 1 : 1 - Math.exp(-dt / LAG_S);
  }

  /** Moves with the character, unless the camera is free; returns whether it moved. */
  private follow(dt: number): boolean {
    const way = this.goal.clone().sub(this.followed);
    if (way.length() <= 1e-5) return false;
    if (this.mode.value === "free") {
      this.followed.copy(this.goal);
      return false;
    }
    way.multiplyScalar(this.share(dt, way.length() > this.height * CUT_HEIGHTS));
    for (const place of [this.followed, this.controls.target, this.camera.position]) place.add(way);
    return true;
  }

  /** Turns to the side of the mode, if no drag turns the camera; returns whether it turned. */
  private keepSide(dt: number): boolean {
    const side = sideOf(this.mode.value);
    if (!side || this.dragging || this.controls.autoRotate) return false;
    const { away, heading } = this;
    const now = sideFrom(away, heading);
    const [turn, lift] = [turnTo(now.azimuth, side.azimuth), side.elevation - now.elevation];
    if (Math.hypot(turn, lift) < 1e-4) return false;
    const share = this.share(dt, false);
    const next = { azimuth: now.azimuth + share * turn, elevation: now.elevation + share * lift };
    const { target } = this.controls;
    this.camera.position.copy(target).addScaledVector(awayTo(next, heading), away.length());
    return true;
  }

  /** Fits a picture of `width` × `height` pixels, of which the lowest `below` and the last `right` are covered. */
  resize(width: number, height: number, below = 0, right = 0): void {
    const freeWidth = Math.max(width - Math.min(right, MOST_RIGHT * width), 1);
    const freeHeight = Math.max(height - Math.min(below, MOST_BELOW * height), 1);
    this.camera.aspect = freeWidth / freeHeight;
    this.camera.setViewOffset(freeWidth, freeHeight, 0, 0, width, height);
  }
}
