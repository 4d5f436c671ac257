/** Brings the session's frames into the scene: actors of the pose stream or the server's own skin, and the overlays. */

import * as THREE from "three";
import type { FrameKind, Hello } from "../net/protocol";
import type { Session } from "../session";
import { Signal } from "../store";
import { token } from "../panels/dom";
import { ActorView } from "./actor";
import { GlbStage } from "./glbactor";
import { contactShadow } from "./ground";
import { type Model, Models } from "./model";
import { BoneOverlay } from "./overlays";
import type { Scene } from "./scene";
import { showSkin, wireColour } from "./skinmode";

export interface Modes {
  skin: boolean;
  wire: boolean;
  bones: boolean;
  tetra: boolean;
}

interface Shown {
  view: ActorView;
  bones: BoneOverlay;
  spot: THREE.Mesh;
}

/** The camera is set anew for another actor or another model, not for a fork or a reconnection. */
function subjectKey(view: ActorView): string {
  return `${view.id} ${view.model.url}`;
}

export class Picture {
  readonly modes = new Signal<Modes>({ skin: true, wire: false, bones: false, tetra: false });
  /** Becomes true when the watched actor was drawn for the first time, false when others come. */
  readonly ready = new Signal(false);
  readonly loading = new Signal<string>("");
  private readonly models = new Models();
  private readonly glb: GlbStage;
  private shown = new Map<number, Shown>();
  private generation = 0;
  /** The tick that the scene shows, and the stream it came by. */
  posed = -1;
  stream: FrameKind = "pose";
  private framed = "";
  private built = "";

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
    for (const { view, bones, spot } of this.shown.values()) {
      bones.dispose();
      this.scene.world.remove(view.root, spot);
    }
    this.shown.clear();
    this.glb.clear();
    hello.casts.forEach((cast, c) => {
      for (const { id } of cast.actors) this.add(new ActorView(id, cast, models[c]!, this.scene.quality === "high"));
    });
    this.recolour();
    this.restyle();
  }

  private add(view: ActorView): void {
    const bones = new BoneOverlay(view, this.scene.renderer.getPixelRatio());
    const spot = contactShadow();
    spot.visible = false;
    view.root.visible = false;
    this.scene.world.add(view.root, bones.object, spot);
    this.shown.set(view.id, { view, bones, spot });
  }

  /** Takes the newest frame, if there is one and the characters are there. */
  update(): void {
    if (!this.shown.size) return;
    if (this.session.pose) this.showPose();
    if (this.session.glb) this.showGlb();
  }

  private showPose(): void {
    const frame = this.session.pose!;
    if (frame.epoch !== this.session.hello.value?.epoch) return;
    this.session.pose = null;
    Object.assign(this, { posed: frame.tick, stream: "pose" });
    this.session.hello.value.casts.forEach((cast, c) => cast.actors.forEach(({ id }, row) => this.shown.get(id)?.view.apply(frame.casts[c]!, row)));
    for (const shown of this.shown.values()) this.settle(shown);
    this.followWatched();
  }

  private settle({ view, bones, spot }: Shown): void {
    view.root.visible = this.session.frames.value === "pose";
    view.root.updateMatrixWorld(true);
    bones.update();
    spot.visible = this.scene.quality === "low";
    spot.position.set(view.root.position.x, 0.002, view.root.position.z);
  }

  private showGlb(): void {
    const fresh = this.glb.apply(this.session.glb!);
    Object.assign(this, { posed: this.session.tick, stream: "glb" });
    this.session.glb = null;
    if (fresh) this.restyle();
    for (const { view, spot } of this.shown.values()) {
      view.root.visible = false;
      spot.visible = false;
    }
    this.followGlb();
  }

  private followGlb(): void {
    const centre = this.glb.centre();
    if (centre) this.scene.follow(centre);
    this.scene.invalidate();
    this.ready.set(true);
  }

  private followWatched(): void {
    const watched = this.shown.get(this.session.actor.value ?? -1);
    if (watched) this.scene.follow(watched.view.root.position);
    if (watched && this.framed !== subjectKey(watched.view)) this.frame();
    this.scene.invalidate();
    this.ready.set(watched !== undefined);
  }

  /** Puts the watched actor into the picture. */
  frame(): void {
    const watched = this.shown.get(this.session.actor.value ?? -1);
    if (!watched) return;
    const box = watched.view.box();
    const height = box.max.y - Math.min(0, box.min.y);
    const span = Math.max(box.max.x - box.min.x, box.max.z - box.min.z);
    this.scene.fit(Math.max(height, 0.5 * span));
    for (const { spot } of this.shown.values()) spot.scale.setScalar(Math.max(0.2 * height, 0.32 * span));
    this.scene.view.subject(box);
    this.scene.view.frame();
    this.framed = subjectKey(watched.view);
    this.scene.invalidate();
  }

  private switchStream(): void {
    const pose = this.session.frames.value === "pose";
    this.glb.root.visible = !pose;
    this.glb.clear();
    this.restyle();
  }

  /** The material of the model that was loaded with textures: by name, else by index where there is one character. */
  private materialFor(index: number, name: string | undefined): THREE.Material | undefined {
    const models = new Set([...this.shown.values()].map(({ view }) => view.model));
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
    for (const shown of this.shown.values()) {
      showSkin(shown.view.meshes, look);
      shown.bones.show(bones, tetra);
      shown.bones.update();
    }
    showSkin(this.glb.meshes, look);
    this.scene.invalidate();
  }

  /** Takes the theme's colours. */
  recolour(): void {
    const [accent, paper, body, ink] = ["--accent", "--view-1", "--bone", "--ink"].map(token) as [string, string, string, string];
    for (const { bones } of this.shown.values()) bones.colour(accent, paper, body);
    wireColour(ink);
    this.scene.ground.colour(token("--grid"), Number(token("--grid-strength")) || 1);
    this.scene.invalidate();
  }

  /** The watched actor's view, for those who measure. */
  watched(): ActorView | null {
    return this.shown.get(this.session.actor.value ?? -1)?.view ?? null;
  }

  /** What is drawn of the characters themselves, without ground and overlays. */
  bodies(): THREE.Object3D[] {
    return this.session.frames.value === "glb" ? [this.glb.root] : [...this.shown.values()].map(({ view }) => view.root);
  }
}
