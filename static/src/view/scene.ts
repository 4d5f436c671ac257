/** Holds renderer, light, ground and camera; draws only if something changed. */

import * as THREE from "three";
import { RoomEnvironment } from "three/examples/jsm/environments/RoomEnvironment.js";
import { FollowCamera } from "./camera/followCamera";
import { Ground } from "./ground";
import { Lights } from "./lights";
import type { Quality } from "./quality";
import { Event } from "../state/event";
import { backgroundOf, type SceneLook } from "../state/sceneSettings";

/** Strengths of the page's own light from all around. */
const [SKY, SKY_WITH_ENVIRONMENT, ENVIRONMENT] = [2.1, 0.9, 0.35];

/** Handles in the picture, by name: where each is drawn, in pixels of the page. */
export interface Handles {
  places(): Record<string, [number, number]>;
}

export class Scene {
  readonly renderer: THREE.WebGLRenderer;
  readonly world = new THREE.Scene();
  readonly view: FollowCamera;
  readonly ground: Ground;
  private readonly lights = new Lights(this.world);
  private readonly floor = new THREE.Mesh(
    new THREE.PlaneGeometry(60, 60).rotateX(-Math.PI / 2),
    new THREE.ShadowMaterial({ opacity: 0.34 }),
  );
  /** Emitted before each drawing. */
  readonly drawing = new Event<THREE.PerspectiveCamera>();
  /** The handles that you can drag. */
  readonly handles: Handles[] = [];
  /** Whether soft spots on the ground stand for shadows. */
  hasSpots = false;
  /** Draw calls of the last drawing. */
  calls = 0;
  /** Controls over the lower end of the picture. */
  private controls: HTMLElement | null = null;
  /** A panel over the right side of the picture. */
  private panel: HTMLElement | null = null;
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
    this.world.add(this.ground.mesh);
    if (high) this.addShadow();
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement ?? canvas);
    this.resize();
  }

  private addShadow(): void {
    const makeEnvironment = new THREE.PMREMGenerator(this.renderer);
    this.world.environment = makeEnvironment.fromScene(new RoomEnvironment(), 0.04).texture;
    this.floor.receiveShadow = true;
    this.floor.renderOrder = -1;
    this.world.add(this.floor);
  }

  /** Lights the stage, and sets what is behind it. */
  light(look: SceneLook): void {
    const { environment, exposure, shadow } = look;
    const high = this.quality === "high";
    this.renderer.toneMappingExposure = exposure;
    this.world.environmentIntensity = environment * ENVIRONMENT;
    this.lights.sky.intensity = environment * (high ? SKY_WITH_ENVIRONMENT : SKY);
    this.lights.castShadows(high && shadow);
    this.floor.visible = shadow;
    this.hasSpots = !high && shadow;
    const behind = backgroundOf(look);
    const { style } = this.canvas.parentElement ?? this.canvas;
    for (const [part, name] of ["--view-1", "--view-2"].entries())
      style.setProperty(name, behind?.[part] ?? "");
    this.invalidate();
  }

  /** Fits light, shadow and grid to a character `height_m` tall. */
  fit(height_m: number): void {
    this.lights.fit(height_m);
    this.ground.fit(height_m);
    this.invalidate();
  }

  /** Moves light, ground and camera with the character at `position`. */
  follow(position: THREE.Vector3, heading?: number): void {
    this.view.aim(position, heading);
    this.ground.follow(position.x, position.z);
    this.floor.position.set(position.x, 0, position.z);
    this.lights.follow(position);
  }

  /** Makes the next `draw` draw. */
  invalidate(): void {
    this.dirty = true;
  }

  /** Keeps what is framed above controls that lie over the lower end of the picture. */
  leaveRoomFor(controls: HTMLElement): void {
    this.controls = controls;
    new ResizeObserver(() => this.resize()).observe(controls);
  }

  /** Keeps what is framed to the left of a panel that lies over the right side of the picture. */
  leaveRoomBeside(panel: HTMLElement): void {
    this.panel = panel;
    new ResizeObserver(() => this.resize()).observe(panel);
  }

  private resize(): void {
    const box = (this.canvas.parentElement ?? this.canvas).getBoundingClientRect();
    const over = this.controls?.getBoundingClientRect();
    const beside = this.panel?.getBoundingClientRect();
    // A panel over the whole picture leaves no room. Narrow controls stand in a corner, where nothing is framed.
    const right = beside && beside.width > 0 && beside.left > box.left ? box.right - beside.left : 0;
    const below = over && over.width > (box.width - right) / 2 ? box.bottom - over.top : 0;
    this.renderer.setSize(Math.max(1, box.width), Math.max(1, box.height), false);
    this.view.resize(box.width, box.height, Math.max(0, below), Math.max(0, right));
    this.drawNow(); // a canvas of another size is blank, and would be shown so until the next frame
  }

  /** Draws, whether something changed or not. */
  drawNow(): void {
    this.dirty = true;
    this.draw(0);
  }

  /** Goes on by `dt` seconds, and draws if something changed; returns whether it did. */
  draw(dt: number): boolean {
    if (this.view.update(dt)) this.dirty = true;
    if (!this.dirty) return false;
    this.dirty = false;
    this.view.camera.updateMatrixWorld();
    this.drawing.emit(this.view.camera);
    this.renderer.render(this.world, this.view.camera);
    this.calls = this.renderer.info.render.calls;
    return true;
  }
}
