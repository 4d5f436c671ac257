/**
 * The watched actor: the camera frames and follows it, the limits of its joints and the path of one of them
 * are drawn.
 */

import type { State } from "../state/state";
import { type Signal, signal } from "@preact/signals-core";
import type { Casting } from "./casting";
import type { CastView } from "./castView";
import { framed, type Framing, withCompany } from "./framing";
import type { LimitMark } from "./limitOverlay";
import { MotionPath } from "./motionPath";
import type { PosedModel } from "./posedModel";
import type { Scene } from "./scene";
import { WatchedLimits } from "./watchedLimits";

/** Changes with the actor and the model, not with a fork or a reconnection; the camera frames each key once. */
const keyOf = ({ id, model }: PosedModel): string => `${id} ${model.url}`;

export class WatchedActor {
  /** True while the actor is drawn. */
  readonly ready = signal(false);
  /** How much the camera shows. */
  readonly framing = signal<Framing>("whole");
  /** Whether the view turns around the actor. */
  readonly turning = signal(false);
  /** The joint whose path is drawn; empty: none. */
  readonly traced = signal<string>("");
  /** The joint that was clicked; empty: none. */
  readonly joint = signal<string>("");
  private readonly path = new MotionPath();
  private readonly limits: WatchedLimits;
  private framed = "";

  constructor(
    private readonly scene: Scene,
    private readonly state: State,
    private readonly casting: Casting,
    private readonly modes: Pick<Signal<{ limits: boolean }>, "value">,
  ) {
    this.limits = new WatchedLimits(scene);
    scene.world.add(this.path.object);
    state.selection.actor.subscribe(() => {
      this.joint.value = "";
      this.drawLimits();
    });
    this.joint.subscribe(() => this.drawLimits());
    this.framing.subscribe(() => this.frame());
    this.turning.subscribe((turning) => scene.view.turn(turning));
    this.traced.subscribe(() => {
      this.path.clear();
      scene.invalidate();
    });
  }

  /** Null: no actor is watched, or its model is not loaded. */
  get model(): PosedModel | null {
    return this.casting.actors.get(this.state.selection.actor.value ?? -1) ?? null;
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
    if (actor && this.framed !== keyOf(actor)) this.frame();
    if (actor) this.trace(actor, tick);
    this.scene.invalidate();
    this.ready.value = actor !== null;
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

  /** Turns the camera to the actor, and to others near it. */
  frame(): void {
    const actor = this.model;
    if (!actor) return;
    const box = actor.box();
    const height = box.max.y - Math.min(0, box.min.y);
    const span = Math.max(box.max.x - box.min.x, box.max.z - box.min.z);
    this.scene.fit(Math.max(height, 0.5 * span));
    for (const cast of this.casting.casts) cast.shade(Math.max(0.2 * height, 0.32 * span));
    const others = [...this.casting.actors.values()];
    const company = others.length > 1;
    this.scene.view.subject(framed(company ? withCompany(actor, box, others) : box, this.framing.value));
    this.scene.view.frame(company);
    const asked = this.state.viewpoint.take();
    if (asked) this.scene.view.standAround(asked);
    this.framed = keyOf(actor);
    this.scene.invalidate();
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
