/** Brings the session's frames into the scene: actors of the pose stream or the server's own skin, and the overlays. */

import * as THREE from "three";
import type { FrameKind, Hello } from "../net/protocol";
import type { Session } from "../session";
import { Signal } from "../store";
import { token } from "../panels/dom";
import type { ActorView } from "./actor";
import { Figure } from "./figure";
import { GlbStage } from "./glbactor";
import { type Model, Models } from "./model";
import type { Scene } from "./scene";
import { showSkin, wireColour } from "./skinmode";

export interface Modes {
  skin: boolean;
  wire: boolean;
  bones: boolean;
  tetra: boolean;
}

/** In sizes of the watched actor: others within this way are put into the picture with it. */
const COMPANY_REACH = 3;

export class Picture {
  readonly modes = new Signal<Modes>({ skin: true, wire: false, bones: false, tetra: false });
  /** Becomes true when the watched actor was drawn for the first time, false when others come. */
  readonly ready = new Signal(false);
  readonly loading = new Signal<string>("");
  private readonly models = new Models();
  private readonly glb: GlbStage;
  private figures = new Map<number, Figure>();
  private generation = 0;
  /** The tick that the scene shows, and the stream it came by. */
  posed = -1;
  stream: FrameKind = "pose";
  private framed = "";
  private built = "";
  private readonly toRoot = new THREE.Vector3();

  constructor(
    readonly scene: Scene,
    private readonly session: Session,
  ) {
    this.glb = new GlbStage(scene.quality === "high", (index, name) => this.materialFor(index, name));
    scene.world.add(this.glb.root);
    session.hello.on((hello) => hello && void this.cast(hello));
    session.frames.on(() => this.switchStream());
    this.modes.on(() => this.restyle());
  }

  /** Loads what the hello names and puts every actor on the stage. */
  private async cast(hello: Hello): Promise<void> {
    // A hello comes with every change of stream, too; the same epoch means the same actors.
    const cast = `${hello.stage}/${hello.epoch}`;
    if (cast === this.built) return;
    this.built = cast;
    const generation = ++this.generation;
    this.loading.set("loading the character");
    try {
      const models = await Promise.all(hello.casts.map((cast) => this.models.get(new URL(cast.model, document.baseURI).href)));
      if (generation === this.generation) this.build(hello, models);
      this.loading.set("");
    } catch (error) {
      this.built = "";
      this.loading.set(`The character could not be loaded: ${error instanceof Error ? error.message : String(error)}`);
    }
  }

  private build(hello: Hello, models: Model[]): void {
    for (const figure of this.figures.values()) figure.dispose();
    this.figures.clear();
    this.glb.clear();
    hello.casts.forEach((cast, c) => {
      for (const { id } of cast.actors) this.figures.set(id, new Figure(id, cast, models[c]!, this.scene));
    });
    this.recolour();
    this.restyle();
  }

  /** Takes the newest frame, if there is one and the characters are there. */
  update(): void {
    if (!this.figures.size) return;
    if (this.session.pose) this.showPose();
    if (this.session.glb) this.showGlb();
  }

  private showPose(): void {
    const frame = this.session.pose!;
    const hello = this.session.hello.value;
    if (frame.epoch !== hello?.epoch) return;
    this.session.pose = null;
    Object.assign(this, { posed: frame.tick, stream: "pose" });
    hello.casts.forEach((cast, c) => cast.actors.forEach(({ id }, row) => this.figures.get(id)?.view.apply(frame.casts[c]!, row)));
    for (const figure of this.figures.values()) figure.settle();
    this.followWatched();
  }

  private showGlb(): void {
    const fresh = this.glb.apply(this.session.glb!);
    Object.assign(this, { posed: this.session.tick, stream: "glb" });
    this.session.glb = null;
    if (fresh) this.restyle();
    for (const figure of this.figures.values()) figure.hide();
    this.followGlb(fresh);
  }

  /** The GLB does not say where the root is: the camera keeps the way from the skin's middle to it that it had when the stream changed. */
  private followGlb(fresh: boolean): void {
    const centre = this.glb.centre();
    if (centre && fresh) this.toRoot.copy(this.scene.view.aimed).sub(centre);
    if (centre) this.scene.follow(centre.add(this.toRoot));
    this.scene.invalidate();
    this.ready.set(true);
  }

  private followWatched(): void {
    const figure = this.figure;
    if (figure) this.scene.follow(figure.view.root.position, figure.heading);
    if (figure && this.framed !== figure.key) this.frame();
    this.scene.invalidate();
    this.ready.set(figure !== null);
  }

  private get figure(): Figure | null {
    return this.figures.get(this.session.actor.value ?? -1) ?? null;
  }

  /** Puts the watched actor into the picture. */
  frame(): void {
    const figure = this.figure;
    if (!figure) return;
    const box = figure.view.box();
    const height = box.max.y - Math.min(0, box.min.y);
    const span = Math.max(box.max.x - box.min.x, box.max.z - box.min.z);
    this.scene.fit(Math.max(height, 0.5 * span));
    for (const other of this.figures.values()) other.shade(Math.max(0.2 * height, 0.32 * span));
    const company = this.figures.size > 1;
    this.scene.view.subject(company ? this.around(figure, box) : box);
    this.scene.view.frame(company);
    this.framed = figure.key;
    this.scene.invalidate();
  }

  /** The box of a figure with those near it, around its root: as many as one can look at together. */
  private around(figure: Figure, own: THREE.Box3): THREE.Box3 {
    const reach = own.getSize(new THREE.Vector3()).length() * COMPANY_REACH;
    const near = new THREE.Box3().setFromCenterAndSize(new THREE.Vector3(), new THREE.Vector3().setScalar(2 * reach));
    const all = own.clone();
    for (const other of this.figures.values()) {
      const away = other.view.root.position.clone().sub(figure.view.root.position);
      if (near.containsPoint(away)) all.union(other.view.box().translate(away));
    }
    return all;
  }

  private switchStream(): void {
    const pose = this.session.frames.value === "pose";
    this.glb.root.visible = !pose;
    this.glb.clear();
    this.restyle();
  }

  /** The material of the model that was loaded with textures: by name, else by index where there is one character. */
  private materialFor(index: number, name: string | undefined): THREE.Material | undefined {
    const models = new Set([...this.figures.values()].map(({ view }) => view.model));
    let first = 0;
    for (const model of models) {
      const own = model.materials.get(index - first);
      if (own && (!name || own.name === name)) return own;
      first += model.materialCount;
    }
    return undefined;
  }

  private restyle(): void {
    const { skin, wire, bones, tetra } = this.modes.value;
    const look = { skin, wire, ghost: skin && tetra };
    for (const figure of this.figures.values()) figure.show(look, bones, tetra);
    showSkin(this.glb.meshes, look);
    this.scene.invalidate();
  }

  /** Takes the theme's colours. */
  recolour(): void {
    const colours = { ink: token("--ink"), accent: token("--accent"), bone: token("--bone") };
    for (const figure of this.figures.values()) figure.colour(colours);
    wireColour(token("--ink"));
    this.scene.ground.colour(token("--grid"), Number(token("--grid-strength")) || 1);
    this.scene.invalidate();
  }

  /** The watched actor's view, for those who measure. */
  watched(): ActorView | null {
    return this.figure?.view ?? null;
  }

  /** What is drawn of the characters themselves, without ground and overlays. */
  bodies(): THREE.Object3D[] {
    return this.session.frames.value === "glb" ? [this.glb.root] : [...this.figures.values()].map(({ view }) => view.root);
  }
}
