/**
 * The watched actor: the camera frames and follows it, the limits of its joints and the path of one of them
 * are drawn.
 */

import * as THREE from "three";
import type { State } from "../state/state";
import { type Signal, signal } from "@preact/signals-core";
import type { Casting } from "./casting";
import type { CastView } from "./castView";
import { sideOf } from "./camera/cameraModes";
import { aroundJoint, framed, withCompany, withGhost, withHeadroom } from "./camera/framing";
import { FramingChoice } from "./camera/framingChoice";
import { fade, keepInSight } from "./cutaway";
import type { LimitMark } from "./limitOverlay";
import { MotionPath } from "./motionPath";
import type { PosedModel } from "./posedModel";
import type { Scene } from "./scene";
import { WatchedLimits } from "./watchedLimits";

/** Changes with the actor and the model, not with a fork or a reconnection; the camera frames each key once. */
const keyOf = ({ id, model }: PosedModel): string => `${id} ${model.url}`;

/** A free camera that stands so many times farther from the actor on another stage frames it. */
const FARTHER = 2;

export class WatchedActor {
  /** True while the actor is drawn. */
  readonly ready = signal(false);
  readonly framing: FramingChoice;
  /** Whether the view turns around the actor. */
  readonly turning = signal(false);
  /** The joint whose path is drawn; empty: none. */
  readonly traced = signal<string>("");
  /** The joint that was clicked; empty: none. */
  readonly joint = signal<string>("");
  private readonly path = new MotionPath();
  private readonly limits: WatchedLimits;
  /** Around the body, as it stood when it was framed, from the root. */
  private readonly body = new THREE.Sphere();
  private framed = "";
  private stage = "";
  /** Where the actor was in the frame before. */
  private readonly before = new THREE.Vector3();

  constructor(
    private readonly scene: Scene,
    private readonly state: State,
    private readonly casting: Casting,
    private readonly ghosts: Casting,
    private readonly modes: Pick<Signal<{ limits: boolean }>, "value">,
  ) {
    this.limits = new WatchedLimits(scene);
    scene.world.add(this.path.object);
    state.selection.actor.subscribe(() => {
      this.joint.value = "";
      this.drawLimits();
    });
    this.joint.subscribe(() => this.drawLimits());
    this.framing = new FramingChoice(state);
    this.framing.chosen.on(() => this.frame());
    this.framing.staged.on(() => this.reframe());
    this.turning.subscribe((turning) => scene.view.turn(turning));
    scene.view.mode.subscribe((mode) => {
      if (sideOf(mode)) this.turning.value = false;
      this.find();
    });
    casting.built.on(() => this.fadeOthers());
    scene.drawing.on((camera) => this.clearView(camera));
    this.traced.subscribe(() => {
      this.path.clear();
      scene.invalidate();
    });
  }

  /** Null: no actor is watched, or its model is not loaded. */
  get model(): PosedModel | null {
    return this.casting.actors.get(this.state.selection.actor.value ?? -1) ?? null;
  }

  /** The same actor on the ghost's stage. */
  private get ghost(): PosedModel | null {
    return this.ghosts.actors.get(this.state.selection.actor.value ?? -1) ?? null;
  }

  /** The cast of the actor. */
  get cast(): CastView | null {
    return this.casting.casts.find(({ cast }) => cast === this.model?.cast) ?? null;
  }

  /** The level of detail with which the actor is drawn; 0: the full skin. */
  get shownLevel(): number {
    return this.cast?.crowd.shownLevels[this.model!.row] ?? 0;
  }

  /** The names of the joints. */
  jointNames(): string[] {
    return (this.model?.cast.names ?? []).filter(Boolean);
  }

  /** The joint whose weights are shown first: the first that moves a skin. */
  firstBone(): string {
    const { cast, model } = this.model ?? {};
    const row = cast?.nodes.findIndex((node) => model?.skinJoints.has(node)) ?? 0;
    return cast?.names[Math.max(0, row)] ?? "";
  }

  /** Follows the actor into the frame of a tick. */
  follow(tick: number): void {
    const actor = this.model;
    this.limits.update();
    if (actor) this.scene.follow(actor.position, actor.heading);
    if (actor && (this.framed !== keyOf(actor) || this.state.viewpoint.isAsked)) this.frame();
    if (actor && this.stage !== this.state.stage.id) this.arrive(actor);
    if (actor) this.stay(actor, tick);
    this.scene.invalidate();
    this.ready.value = actor !== null;
  }

  private fadeOthers(): void {
    const { cast } = this;
    for (const other of this.casting.casts) fade(other.crowd.bodies, cast !== null && other !== cast);
  }

  /** Lets what covers the actor fade. */
  private clearView(camera: THREE.PerspectiveCamera): void {
    const actor = this.ready.value ? this.model : null;
    const { center, radius } = this.body;
    keepInSight(actor && new THREE.Sphere(center.clone().add(actor.position), radius), camera);
  }

  /** Remembers where the actor is. */
  private stay(actor: PosedModel, tick: number): void {
    this.stage = this.state.stage.id;
    this.before.copy(actor.position);
    this.trace(actor, tick);
  }

  /** Finds the actor on another stage. */
  private arrive(actor: PosedModel): void {
    const { mode, camera } = this.scene.view;
    const [away, before] = [actor.position, this.before].map((place) => camera.position.distanceTo(place));
    if (this.stage && mode.value === "free" && away! > FARTHER * before!) this.frame();
    else this.find();
  }

  /** Frames the actor if the camera looks elsewhere: on another stage, or after it was free. */
  private find(): void {
    if (!this.scene.view.sees) this.frame();
    this.scene.invalidate();
  }

  /** Lets go of an actor that has left. */
  leave(): void {
    this.limits.drop();
    this.ready.value = false;
  }

  /** Adds the place of the traced joint to its path. */
  private trace(actor: PosedModel, tick: number): void {
    const joint = actor.cast.names.indexOf(this.traced.value);
    if (!this.traced.value || joint < 0) return;
    const e = actor.jointWorld(joint);
    this.path.add(`${keyOf(actor)} ${joint}`, tick, [e[12]!, e[13]!, e[14]!]);
  }

  /** Turns the camera to the actor, to others near it, and to its ghost. */
  frame(): void {
    const actor = this.model;
    if (!actor) return;
    this.scene.view.frame(this.subject(actor));
    const asked = this.state.viewpoint.take();
    if (asked) this.scene.view.standAround(asked);
    this.framed = keyOf(actor);
    this.scene.invalidate();
  }

  /** Turns the camera to the chosen joint, from where it looks; if none is chosen, to the actor. */
  frameChosen(): void {
    const actor = this.model;
    const joint = actor && this.joint.value ? actor.cast.names.indexOf(this.joint.value) : -1;
    if (!actor || joint < 0) return this.frame();
    const e = actor.jointWorld(joint);
    const place = new THREE.Vector3(e[12], e[13], e[14]).sub(actor.position);
    this.scene.view.subject(aroundJoint(actor.box(), place));
    this.scene.view.glide();
    this.scene.invalidate();
  }

  /** Moves the camera to the shown framing; it looks from where it looked. */
  private reframe(): void {
    const actor = this.model;
    if (!actor || this.framed !== keyOf(actor) || this.state.people.following.value !== null) return;
    this.subject(actor);
    if (this.scene.view.mode.value !== "free") this.scene.view.glide();
  }

  /** Tells the scene and the camera what to frame; returns whether others are in the picture. */
  private subject(actor: PosedModel): boolean {
    const box = actor.box();
    const height = box.max.y - Math.min(0, box.min.y);
    const span = Math.max(box.max.x - box.min.x, box.max.z - box.min.z);
    this.scene.fit(Math.max(height, 0.5 * span));
    for (const cast of this.casting.casts) cast.shade(Math.max(0.2 * height, 0.32 * span));
    box.getBoundingSphere(this.body);
    this.fadeOthers();
    const others = [...this.casting.actors.values()];
    const framing = this.framing.shown.value;
    const company = others.length > 1 && (framing === "whole" || framing === "wide");
    const shown = framed(company ? withCompany(actor, box, others) : box, framing);
    const seen = framing === "whole" ? withHeadroom(shown) : shown;
    this.scene.view.subject(this.ghost ? withGhost(actor, seen, this.ghost) : seen);
    return company;
  }

  /** Draws the limits of the joints. */
  drawLimits(): void {
    const { machine } = this.state;
    const own = (machine.isActors && machine.info.value?.limits) || [];
    this.limits.draw(this.model, own, this.joint.value, this.modes.value.limits);
  }

  /** The limits that can be seen. */
  marks(): LimitMark[] {
    return this.limits.marks();
  }

  /** The joints that show a circle. */
  circles(): ReadonlySet<string> {
    return new Set([...(this.cast?.bones.jointNames() ?? []), ...this.limits.jointNames()]);
  }

  /** Applies the theme's colours. */
  colour(accent: string): void {
    this.limits.colour();
    this.path.colour(accent);
  }
}
