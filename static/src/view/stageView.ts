/** Draws the session's frames: actors of the pose stream, or the server's skin of the glb stream. */

import * as THREE from "three";
import { Meter } from "../net/meter";
import type { FrameKind } from "../net/protocol";
import type { State } from "../state/state";
import { type Signal, signal } from "@preact/signals-core";
import { token } from "../ui/dom";
import { Casting } from "./casting";
import { type CastView, themeColours } from "./castView";
import { MOST_INFLUENCES } from "./influences";
import type { Crowd } from "./crowd";
import { DetailChoice } from "./detailChoice";
import { GhostView } from "./ghostView";
import { GlbStage } from "./glbStage";
import { Looks } from "./looks";
import { paintSkins } from "./paint";
import { type Body, inkColour } from "./bodies";
import { materialOf } from "./model";
import type { PosedModel } from "./posedModel";
import type { Scene } from "./scene";
import { showSkin, wireColour } from "./skinMode";
import { SkinProof } from "./skinProof";
import { actorAt } from "./actorPick";
import { Terrain } from "./terrain";
import { WatchedActor } from "./watchedActor";

export interface Modes {
  skin: boolean;
  wire: boolean;
  bones: boolean;
  tetra: boolean;
  limits: boolean;
}

/** Milliseconds that drawing waits for the answer to an edit. */
const LONGEST_WAIT_MS = 1000;

/** Limits of more joints hide the body: they are drawn on request. */
const FEW_LIMITS = 6;

export class StageView {
  readonly modes = signal<Modes>({ skin: true, wire: false, bones: false, tetra: false, limits: true });
  readonly looks = new Looks();
  /** The level of detail. */
  readonly detail = new DetailChoice();
  readonly proof: SkinProof;
  readonly watched: WatchedActor;
  readonly ghost: GhostView;
  private readonly glb: GlbStage;
  private readonly terrain = new Terrain();
  private readonly casting: Casting;
  /** Counts drawings. */
  readonly drawn = new Meter();
  private drawnAt = 0;
  /** Tick and stream of the drawn frame. */
  posed = -1;
  stream: FrameKind = "pose";

  constructor(
    readonly scene: Scene,
    private readonly state: State,
  ) {
    this.casting = new Casting(scene, state, this.detail);
    this.casting.cleared.on(() => this.clear());
    this.casting.built.on(() => this.dress());
    this.ghost = new GhostView(scene, state, new Casting(scene, state, this.detail));
    this.watched = new WatchedActor(scene, state, this.casting, this.ghost.casting, this.modes);
    this.glb = new GlbStage(scene.quality === "high", (index, name) =>
      materialOf(new Set(this.crowds.map(({ model }) => model)), index, name),
    );
    this.proof = new SkinProof(scene.renderer, state);
    scene.world.add(this.glb.root);
    state.stage.hello.subscribe((hello) => hello && void this.casting.take(hello));
    state.frames.kind.subscribe(() => this.switchStream());
    this.modes.subscribe(() => this.restyle());
    state.frames.skinning.subscribe(() => this.restyle());
    scene.world.add(this.terrain.mesh);
    state.machine.info.subscribe((machine) => {
      this.modes.value = { ...this.modes.value, limits: (machine?.limits.length ?? 0) <= FEW_LIMITS };
      this.watched.drawLimits();
      this.terrain.show(machine?.ground ?? []);
      scene.invalidate();
    });
    this.watched.joint.subscribe((joint) => {
      if (joint) this.looks.bone.value = joint;
    });
    for (const look of Object.values(this.looks)) (look as Signal<string>).subscribe(() => this.restyle());
    scene.drawing.on((camera) => this.casts.forEach((cast) => cast.arrange(camera)));
    this.detail.byHand.subscribe(() => scene.invalidate());
  }

  private get casts(): readonly CastView[] {
    return this.casting.casts;
  }

  private get crowds(): Crowd[] {
    return this.casts.map(({ crowd }) => crowd);
  }

  /** What is being loaded, or why the stage cannot be shown; empty: it is shown. */
  get loading(): Signal<string> {
    return this.casting.loading;
  }

  /** The actors have left; frames of others must not move what they leave behind. */
  private clear(): void {
    this.watched.leave();
    this.glb.clear();
    this.scene.invalidate();
  }

  private dress(): void {
    if (this.crowds.some(({ parts }) => parts.most > MOST_INFLUENCES)) this.leaveSkinToServer();
    this.recolour();
    this.restyle();
  }

  /** The one thing that the pose stream cannot express: a vertex with more bones than the GPU blends. */
  private leaveSkinToServer(): void {
    this.state.notices.emit(
      `A vertex follows more than ${MOST_INFLUENCES} bones, which the GPU does not blend: the server skins.`,
    );
    this.state.frames.stream("glb");
  }

  /** Without a graphics card, drawing waits for the answer to an edit: together they would hold up the keyboard. */
  private waits(now: number): boolean {
    const { quality } = this.scene;
    return quality === "low" && this.state.editing.queue.isBusy && now - this.drawnAt < LONGEST_WAIT_MS;
  }

  /** Draws if something changed; `now`: the browser's time, milliseconds. */
  draw(now: number, dt: number): void {
    if (this.waits(now) || !this.scene.draw(dt)) return;
    this.drawn.add(now);
    this.drawnAt = now;
  }

  /** Shows the newest frame, if the models are loaded. */
  update(): void {
    this.ghost.update();
    if (!this.casting.actors.size) return;
    if (this.state.frames.pose) this.showPose();
    if (this.state.frames.glb) this.showGlb();
    this.prove();
  }

  private prove(): void {
    const { crowds, watched } = this;
    const crowd = watched.cast?.crowd;
    if (this.stream === "glb") this.proof.idle();
    else if (crowd && watched.ready.value) this.proof.compare(crowds, crowd, watched.model!.row, this.posed);
  }

  private showPose(): void {
    const frame = this.state.frames.pose!;
    const hello = this.state.stage.hello.value;
    if (frame.epoch !== hello?.epoch) return;
    this.state.frames.pose = null;
    Object.assign(this, { posed: frame.tick, stream: "pose" });
    this.casts.forEach((cast, c) => cast.take(frame.casts[c]!));
    this.watched.follow(this.posed);
  }

  private showGlb(): void {
    const fresh = this.glb.apply(this.state.frames.glb!, [...this.casting.actors.keys()]);
    Object.assign(this, { posed: this.state.stage.tick, stream: "glb" });
    this.state.frames.glb = null;
    if (fresh) this.restyle();
    let first = 0;
    for (const view of this.casts)
      view.place(this.glb.actors.slice(first, (first += view.cast.actors.length)));
    this.watched.follow(this.posed);
  }

  private switchStream(): void {
    const pose = this.state.frames.kind.value === "pose";
    this.glb.root.visible = !pose;
    this.glb.clear();
    this.scene.invalidate();
  }

  private restyle(): void {
    const { skin, wire, bones, tetra } = this.modes.value;
    const look = { skin, wire, ghost: skin && tetra };
    const solid = tetra ? this.looks.solid.value : null;
    for (const cast of this.casts) cast.skin(this.state.frames.skinning.value);
    paintSkins(this.crowds, this.glb.meshes, this.looks);
    for (const cast of this.casts) cast.show(look, bones, solid);
    showSkin(this.glb.meshes, look);
    this.watched.drawLimits();
    this.scene.invalidate();
  }

  /** Applies the theme's colours. */
  recolour(): void {
    const colours = themeColours();
    this.ghost.dress();
    for (const cast of this.casts) cast.colour(colours);
    this.watched.colour(colours.accent);
    wireColour(token("--ink"));
    inkColour(token("--ink"));
    this.scene.ground.colour(token("--grid"), Number(token("--grid-strength")) || 1);
    this.scene.invalidate();
  }

  everyActor(): PosedModel[] {
    return [...this.casting.actors.values()];
  }

  /** Returns the id of the actor that is drawn at a pixel of the page; null: there is none. */
  actorAt(clientX: number, clientY: number): number | null {
    const { renderer, world, view, canvas } = this.scene;
    const box = canvas.getBoundingClientRect();
    const at = new THREE.Vector2(
      ((clientX - box.left) / box.width) * 2 - 1,
      1 - ((clientY - box.top) / box.height) * 2,
    );
    return actorAt(renderer, world, view.camera, this.bodies(), at);
  }

  /** Number of actors whose bones are drawn. */
  get overlays(): number {
    return this.casts.reduce((all, { cast, bones }) => all + (bones.visible ? cast.actors.length : 0), 0);
  }

  /** What the characters are drawn with in the present stream, of each crowd its full skin. */
  meshes(): Body[] {
    return this.state.frames.kind.value === "glb"
      ? this.glb.meshes
      : this.crowds.flatMap(({ levels }) => levels[0]!.bodies);
  }

  /** The objects of the characters, without ground and overlays. */
  bodies(): THREE.Object3D[] {
    return this.state.frames.kind.value === "glb" ? [this.glb.root] : this.crowds.map(({ root }) => root);
  }
}
