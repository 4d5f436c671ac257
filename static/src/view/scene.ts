/** Holds renderer, light, ground and camera; draws only if something changed. */

import * as THREE from "three";
import { RoomEnvironment } from "three/examples/jsm/environments/RoomEnvironment.js";
import { FollowCamera } from "./camera";
import { Ground } from "./ground";
import type { Quality } from "./quality";
import { Event } from "../state/event";

const SHADOW_PIXELS = 2048;

/** Handles in the picture, by name: where each is drawn, in pixels of the page. */
export interface Handles {
  places(): Record<string, [number, number]>;
}

export class Scene {
  readonly renderer: THREE.WebGLRenderer;
  readonly world = new THREE.Scene();
  readonly view: FollowCamera;
  readonly ground: Ground;
  private readonly key = new THREE.DirectionalLight(0xfff3e6, 2.8);
  private readonly rim = new THREE.DirectionalLight(0xbcd2ff, 0.9);
  private readonly sky = new THREE.HemisphereLight(0xe8f0ff, 0x6b6157, 2.1);
  private readonly floor = new THREE.Mesh(
    new THREE.PlaneGeometry(60, 60).rotateX(-Math.PI / 2),
    new THREE.ShadowMaterial({ opacity: 0.34 }),
  );
  /** Emitted before each drawing. */
  readonly drawing = new Event<THREE.PerspectiveCamera>();
  /** The handles that you can drag. */
  readonly handles: Handles[] = [];
  /** Draw calls of the last drawing. */
  calls = 0;
  /** Controls over the lower end of the picture. */
  private controls: HTMLElement | null = null;
  private height = 1.8;
  private dirty = true;

  constructor(
    readonly canvas: HTMLCanvasElement,
    readonly quality: Quality,
    still: () => boolean,
  ) {
    const high = quality === "high";
    this.renderer = new THREE.WebGLRenderer({
      canvas,
      antialias: high,
      alpha: true,
      powerPreference: "high-performance",
    });
    this.renderer.setPixelRatio(high ? Math.min(window.devicePixelRatio, 2) : 1);
    this.renderer.toneMapping = THREE.NeutralToneMapping;
    this.renderer.shadowMap.enabled = high;
    this.renderer.shadowMap.type = THREE.PCFShadowMap;
    this.ground = new Ground(quality);
    this.view = new FollowCamera(canvas, still);
    this.view.controls.addEventListener("change", () => this.invalidate());
    this.world.add(this.ground.mesh, this.sky, this.key, this.key.target, this.rim, this.rim.target);
    if (high) this.addShadow();
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement ?? canvas);
    this.resize();
  }

  private addShadow(): void {
    const makeEnvironment = new THREE.PMREMGenerator(this.renderer);
    this.world.environment = makeEnvironment.fromScene(new RoomEnvironment(), 0.04).texture;
    this.world.environmentIntensity = 0.35;
    this.sky.intensity = 0.9;
    this.key.castShadow = true;
    this.key.shadow.mapSize.set(SHADOW_PIXELS, SHADOW_PIXELS);
    this.key.shadow.radius = 5;
    this.key.shadow.bias = -0.0004;
    this.key.shadow.normalBias = 0.02;
    this.floor.receiveShadow = true;
    this.floor.renderOrder = -1;
    this.world.add(this.floor);
  }

  /** Fits light, shadow and grid to a character `height_m` tall. */
  fit(height_m: number): void {
    this.height = height_m;
    this.ground.fit(height_m);
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
    this.invalidate();
  }

  /** Moves light, ground and camera with the character at `position`. */
  follow(position: THREE.Vector3, heading?: number): void {
    this.view.aim(position, heading);
    this.ground.follow(position.x, position.z);
    this.floor.position.set(position.x, 0, position.z);
    this.placeLight(this.key, position, [1.6, 3.2, 2.0]);
    this.placeLight(this.rim, position, [-1.8, 2.2, -2.4]);
  }

  private placeLight(
    light: THREE.DirectionalLight,
    position: THREE.Vector3,
    [x, y, z]: [number, number, number],
  ): void {
    light.target.position.set(position.x, position.y + 0.5 * this.height, position.z);
    light.position.copy(position).add(new THREE.Vector3(x, y, z).multiplyScalar(this.height));
  }

  /** Makes the next `draw` draw. */
  invalidate(): void {
    this.dirty = true;
  }

  /** Keeps what is framed above the element, which lies over the lower end of the picture. */
  leaveRoomFor(controls: HTMLElement): void {
    this.controls = controls;
    new ResizeObserver(() => this.resize()).observe(controls);
  }

  private resize(): void {
    const box = (this.canvas.parentElement ?? this.canvas).getBoundingClientRect();
    const covered = this.controls ? box.bottom - this.controls.getBoundingClientRect().top : 0;
    this.renderer.setSize(Math.max(1, box.width), Math.max(1, box.height), false);
    this.view.resize(box.width, box.height, Math.max(0, covered));
    this.dirty = true;
    this.draw(0); // a canvas of another size is blank, and would be shown so until the next frame
  }

  /** Draws if something changed; returns whether it did. */
  draw(dt: number): boolean {
    if (this.view.update(dt)) this.dirty = true;
    if (!this.dirty) return false;
    this.dirty = false;
    this.drawing.emit(this.view.camera);
    this.renderer.render(this.world, this.view.camera);
    this.calls = this.renderer.info.render.calls;
    return true;
  }
}
