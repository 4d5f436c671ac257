/** Draws the session's frames: actors of the pose stream, or the server's skin of the glb stream. */

import * as THREE from "three";
import type { FrameKind, Hello } from "../net/protocol";
import type { Session } from "../state/session";
import { Signal } from "../state/signal";
import { token } from "../ui/dom";
import type { PosedModel } from "./posedModel";
import { ActorView } from "./actorView";
import { framed, type Framing, withCompany } from "./framing";
import { GlbStage } from "./glbStage";
import type { LimitMark } from "./limitOverlay";
import { MotionPath } from "./motionPath";
import { materialOf, type Model, Models } from "./model";
import type { Scene } from "./scene";
import { showSkin, wireColour } from "./skinMode";
import { Terrain } from "./terrain";

export interface Modes {
  skin: boolean;
  wire: boolean;
  bones: boolean;
  tetra: boolean;
  limits: boolean;
}

/** Limits of more joints hide the body: they are drawn on request. */
const FEW_LIMITS = 6;

export class StageView {
  readonly modes = new Signal<Modes>({ skin: true, wire: false, bones: false, tetra: false, limits: true });
  /** True while the watched actor is drawn. */
  readonly ready = new Signal(false);
  readonly loading = new Signal<string>("");
  /** How much the camera shows. */
  readonly framing = new Signal<Framing>("whole");
  /** Whether the view turns around the character. */
  readonly turning = new Signal(false);
  /** The joint whose path is drawn; empty: none. */
  readonly traced = new Signal<string>("");
  readonly path = new MotionPath();
  /** The joint that was clicked; empty: none. */
  readonly joint = new Signal<string>("");
  private readonly models = new Models();
  private readonly glb: GlbStage;
  private readonly terrain = new Terrain();
  private actors = new Map<number, ActorView>();
  private generation = 0;
  /** Tick and stream of the drawn frame. */
  posed = -1;
  stream: FrameKind = "pose";
  private framed = "";
  private built = "";

  constructor(
    readonly scene: Scene,
    private readonly session: Session,
  ) {
    this.glb = new GlbStage(scene.quality === "high", (index, name) =>
      materialOf(new Set([...this.actors.values()].map(({ view }) => view.model)), index, name),
    );
    scene.world.add(this.glb.root, this.path.object);
    session.hello.on((hello) => hello && void this.cast(hello));
    session.frames.on(() => this.switchStream());
    this.modes.on(() => this.restyle());
    scene.world.add(this.terrain.mesh);
    session.machine.on((machine) => {
      this.modes.set({ ...this.modes.value, limits: (machine?.limits.length ?? 0) <= FEW_LIMITS });
      this.limit();
      this.terrain.show(machine?.ground ?? []);
      scene.invalidate();
    });
    session.actor.on(() => {
      this.joint.set("");
      this.limit();
    });
    this.joint.on(() => this.limit());
    this.framing.on(() => this.frame());
    this.turning.on((turning) => scene.view.turn(turning));
    this.traced.on(() => {
      this.path.clear();
      scene.invalidate();
    });
  }

  /** Loads the models of a hello and puts its actors on the stage. */
  private async cast(hello: Hello): Promise<void> {
    // A change of stream brings a hello, too; the same epoch means the same actors.
    const cast = `${hello.stage}/${hello.epoch}`;
    if (cast === this.built) return;
    this.built = cast;
    const generation = ++this.generation;
    this.clear();
    this.loading.set("loading the character");
    try {
      const models = await Promise.all(
        hello.casts.map((cast) => this.models.get(new URL(cast.model, document.baseURI).href)),
      );
      if (generation !== this.generation) return;
      this.build(hello, models);
      this.loading.set("");
    } catch (error) {
      if (generation !== this.generation) return;
      this.built = "";
      this.loading.set(
        `The character cannot be loaded: ${error instanceof Error ? error.message : String(error)}`,
      );
    }
  }

  /** Takes the actors off the stage; frames of other actors must not move them. */
  private clear(): void {
    for (const actor of this.actors.values()) actor.dispose();
    this.actors.clear();
    this.glb.clear();
    this.ready.set(false);
    this.scene.invalidate();
  }

  private build(hello: Hello, models: Model[]): void {
    hello.casts.forEach((cast, c) => {
      for (const { id } of cast.actors) this.actors.set(id, new ActorView(id, cast, models[c]!, this.scene));
    });
    this.recolour();
    this.restyle();
  }

  /** Shows the newest frame, if the models are loaded. */
  update(): void {
    if (!this.actors.size) return;
    if (this.session.pose) this.showPose();
    if (this.session.glb) this.showGlb();
  }

  private showPose(): void {
    const frame = this.session.pose!;
    const hello = this.session.hello.value;
    if (frame.epoch !== hello?.epoch) return;
    this.session.pose = null;
    Object.assign(this, { posed: frame.tick, stream: "pose" });
    hello.casts.forEach((cast, c) =>
      cast.actors.forEach(({ id }, row) => this.actors.get(id)?.view.apply(frame.casts[c]!, row)),
    );
    for (const actor of this.actors.values()) actor.settle();
    this.followSelected();
  }

  private showGlb(): void {
    const fresh = this.glb.apply(this.session.glb!);
    Object.assign(this, { posed: this.session.tick, stream: "glb" });
    this.session.glb = null;
    if (fresh) this.restyle();
    const ids = this.session.hello.value?.casts.flatMap((cast) => cast.actors.map(({ id }) => id)) ?? [];
    ids.forEach((id, row) => this.actors.get(id)?.place(this.glb.actors[row]));
    this.followSelected();
  }

  private followSelected(): void {
    const actor = this.actor;
    if (actor) this.scene.follow(actor.view.root.position, actor.heading);
    if (actor && this.framed !== actor.key) this.frame();
    if (actor) this.trace(actor);
    this.scene.invalidate();
    this.ready.set(actor !== null);
  }

  /** Adds the place of the traced joint to its path. */
  private trace(actor: ActorView): void {
    const joint = actor.view.joints.findIndex((object) => object?.name === this.traced.value);
    if (!this.traced.value || joint < 0) return;
    const e = actor.view.jointWorld(joint);
    this.path.add(`${actor.key} ${joint}`, this.posed, [e[12]!, e[13]!, e[14]!]);
  }

  /** The names of the watched actor's joints. */
  jointNames(): string[] {
    return (this.actor?.view.joints ?? []).flatMap((joint) => (joint?.name ? [joint.name] : []));
  }

  private get actor(): ActorView | null {
    return this.actors.get(this.session.actor.value ?? -1) ?? null;
  }

  /** Frames the watched actor. */
  frame(): void {
    const actor = this.actor;
    if (!actor) return;
    const box = actor.view.box();
    const height = box.max.y - Math.min(0, box.min.y);
    const span = Math.max(box.max.x - box.min.x, box.max.z - box.min.z);
    this.scene.fit(Math.max(height, 0.5 * span));
    for (const other of this.actors.values()) other.shade(Math.max(0.2 * height, 0.32 * span));
    const others = [...this.actors.values()].map(({ view }) => view);
    const company = others.length > 1;
    this.scene.view.subject(framed(company ? withCompany(actor.view, box, others) : box, this.framing.value));
    this.scene.view.frame(company);
    this.framed = actor.key;
    this.scene.invalidate();
  }

  private switchStream(): void {
    const pose = this.session.frames.value === "pose";
    this.glb.root.visible = !pose;
    this.glb.clear();
    this.scene.invalidate();
  }

  /** Draws the limits of the watched actor's joints. */
  private limit(): void {
    const limits = this.session.machine.value?.limits ?? [];
    for (const actor of this.actors.values()) actor.limits.show(false);
    const actor = this.actor;
    if (!actor || this.session.cast?.machine !== this.session.machine.value?.name) return;
    actor.limits.take(limits);
    actor.limits.select(this.joint.value);
    actor.limits.show(this.modes.value.limits);
    this.scene.invalidate();
  }

  private restyle(): void {
    const { skin, wire, bones, tetra } = this.modes.value;
    const look = { skin, wire, ghost: skin && tetra };
    for (const actor of this.actors.values()) actor.show(look, bones, tetra);
    showSkin(this.glb.meshes, look);
    this.limit();
    this.scene.invalidate();
  }

  /** Applies the theme's colours. */
  recolour(): void {
    const colours = { ink: token("--ink"), accent: token("--accent"), bone: token("--bone") };
    for (const actor of this.actors.values()) actor.colour(colours);
    wireColour(token("--ink"));
    this.path.colour(colours.accent);
    this.scene.ground.colour(token("--grid"), Number(token("--grid-strength")) || 1);
    this.scene.invalidate();
  }

  /** The limits of the watched actor's joints that can be seen. */
  marks(): LimitMark[] {
    return this.actor?.limits.marks() ?? [];
  }

  /** The joints of the watched actor that show a circle. */
  circles(): ReadonlySet<string> {
    const { bones, limits } = this.actor ?? {};
    return new Set([...(bones?.jointNames() ?? []), ...(limits?.jointNames() ?? [])]);
  }

  /** The watched actor's model. */
  selected(): PosedModel | null {
    return this.actor?.view ?? null;
  }

  /** Number of actors whose bones are drawn. */
  get overlays(): number {
    return [...this.actors.values()].filter(({ bones }) => bones.visible).length;
  }

  /** The objects of the characters, without ground and overlays. */
  bodies(): THREE.Object3D[] {
    return this.session.frames.value === "glb"
      ? [this.glb.root]
      : [...this.actors.values()].map(({ view }) => view.root);
  }
}
