/** The picture of a dropped model, with a renderer of its own while it is looked at. */

import * as THREE from "three";
import { RoomEnvironment } from "three/examples/jsm/environments/RoomEnvironment.js";
import { el, token } from "../ui/dom";
import { FollowCamera } from "./camera/followCamera";
import { JointLines } from "./jointLines";
import { Lights } from "./lights";
import type { LookedModel } from "./lookedModel";
import type { Model } from "./model";
import type { Quality } from "./quality";

/** After a pause of the page the clips move on by no more, seconds. */
const LONGEST_STEP_S = 0.1;

/** Returns the box of a model; of one without meshes: of its nodes. */
function boxOf({ scene, nodes }: Model): THREE.Box3 {
  const box = new THREE.Box3().setFromObject(scene);
  if (box.isEmpty())
    for (const node of nodes) box.expandByPoint(new THREE.Vector3().setFromMatrixPosition(node.matrixWorld));
  const size = Math.max(box.getSize(new THREE.Vector3()).length(), 1e-3);
  return box.expandByScalar(0.02 * size);
}

export class LookedPicture {
  readonly canvas = el("canvas", {
    class: "look-canvas",
    role: "img",
    "aria-label": "the dropped model: drag to turn",
  });
  private readonly renderer: THREE.WebGLRenderer;
  private readonly world = new THREE.Scene();
  private readonly camera = new FollowCamera(this.canvas, () => true);
  private readonly joints: JointLines;
  private readonly size = new ResizeObserver(() => this.resize());
  private readonly changes: readonly (() => void)[];
  private dirty = true;
  private last = performance.now();
  private running = true;

  constructor(
    model: Model,
    private readonly looked: LookedModel,
    quality: Quality,
  ) {
    const high = quality === "high";
    this.renderer = new THREE.WebGLRenderer({ canvas: this.canvas, antialias: high, alpha: true });
    this.renderer.setPixelRatio(high ? Math.min(window.devicePixelRatio, 2) : 1);
    this.renderer.toneMapping = THREE.NeutralToneMapping;
    this.joints = new JointLines(model.nodes, model.skinJoints, token("--accent"));
    this.joints.lines.visible = looked.meshes.length === 0;
    this.world.add(model.scene, this.joints.lines);
    if (high) this.addEnvironment();
    this.frame(boxOf(model));
    this.camera.controls.addEventListener("change", () => this.invalidate());
    this.size.observe(this.canvas);
    const { hidden, weights, playing, time } = looked;
    this.changes = [hidden, weights, playing, time].map((part) => part.subscribe(() => this.invalidate()));
    requestAnimationFrame((now) => this.draw(now));
  }

  private addEnvironment(): void {
    const maker = new THREE.PMREMGenerator(this.renderer);
    this.world.environment = maker.fromScene(new RoomEnvironment(), 0.04).texture;
    this.world.environmentIntensity = 0.35;
  }

  private frame(box: THREE.Box3): void {
    const lights = new Lights(this.world);
    const high = this.world.environment !== null;
    if (high) lights.sky.intensity = 0.9;
    lights.fit(box.getSize(new THREE.Vector3()).y);
    lights.follow(box.getCenter(new THREE.Vector3()).setY(box.min.y));
    this.camera.subject(box);
  }

  get showsJoints(): boolean {
    return this.joints.lines.visible;
  }

  set showsJoints(on: boolean) {
    this.joints.lines.visible = on;
    this.invalidate();
  }

  /** Makes the next frame draw. */
  invalidate(): void {
    this.dirty = true;
  }

  /** Ends the drawing, and gives the memory back. */
  end(): void {
    this.running = false;
    this.changes.forEach((forget) => forget());
    this.size.disconnect();
    this.camera.controls.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  private resize(): void {
    const { width, height } = this.canvas.getBoundingClientRect();
    if (!width || !height) return;
    this.renderer.setSize(width, height, false);
    this.camera.resize(width, height);
    this.camera.frame();
    this.invalidate();
  }

  private draw(now: number): void {
    if (!this.running) return;
    requestAnimationFrame((next) => this.draw(next));
    const dt = Math.min(LONGEST_STEP_S, (now - this.last) / 1000);
    this.last = now;
    const [played, turned] = [this.looked.advance(dt), this.camera.update(dt)];
    if (played || turned) this.dirty = true;
    if (!this.dirty) return;
    this.dirty = false;
    this.joints.follow();
    this.renderer.render(this.world, this.camera.camera);
  }
}
