/**
 * Buttons for the points and directions of the watched machine: a handle to drag in the scene for each, and, for a
 * machine with `gaze` and `look`, a character that looks at the pointer. The handle of a target shows by itself in
 * states in which a solver reaches for it; the handle of a chain that you take hold of is at the chain's free end.
 */

import "./targets.css";
import { computed, type ReadonlySignal, signal } from "@preact/signals-core";
import { html, nothing, type TemplateResult } from "lit-html";
import * as THREE from "three";
import type { Aim, Grip, Point } from "../../state/points";
import { aimsOf, canLook, GAZE, gripsOf, LOOK, reachedIn } from "../../state/points";
import type { App } from "../../view/app";
import { draw } from "../../ui/draw";
import type { PosedModel } from "../../view/posedModel";
import { onFacingPlane, PointHandles } from "../../view/pointHandles";
import { type Frame, placeOf, valueAt } from "./handlePlace";

/** Metres in front of the character at which the pointer's plane stands. */
const IN_FRONT = 1.2;
/** The size of a handle, and how far from its beginning a direction's handle is, in heights of the character. */
const [SIZE, AWAY] = [0.035, 0.35];
/** Metres: a point that is nearer to its first place counts as being there. */
const MOVED = 1e-5;

class TargetsPanel {
  private readonly handles: PointHandles;
  private readonly aims: ReadonlySignal<ReadonlyMap<string, Aim>>;
  private readonly grips: ReadonlySignal<ReadonlyMap<string, Grip>>;
  /** The points whose handles are shown. */
  private readonly shown = signal<ReadonlySet<string>>(new Set());
  private readonly looks = signal(false);
  private reached = new Set<string>();
  /** Where the handles are drawn. */
  private readonly drawn = new Map<string, Point>();
  private measured: PosedModel | null = null;
  private tall = 1.8;

  constructor(
    private readonly host: HTMLElement,
    private readonly app: App,
  ) {
    const { scene } = app.view;
    this.handles = new PointHandles(
      scene,
      (name, place) => this.move(name, place),
      (name, isHeld) => this.hold(name, isHeld),
    );
    this.aims = computed(() => aimsOf(app.machine.info.value));
    this.grips = computed(() => gripsOf(app.machine.info.value));
    for (const begins of [app.machine.info, app.selection.actor]) begins.subscribe(() => this.begin());
    draw(host, () => this.buttons());
    app.selection.layerStates.subscribe(([base]) => this.enter(base ?? ""));
    app.parameters.all.subscribe(() => this.place());
    scene.canvas.addEventListener("pointermove", (event) => this.follow(event));
    app.frame.on(() => this.update());
  }

  /** Moves handles along: a chain's handle with the chain's end, a direction or a point in model space with the actor. */
  private update(): void {
    if (this.app.view.watched.ready.value) for (const name of this.shown.value) this.put(name);
  }

  /** Where a handle belongs in the scene; null: its chain is not drawn yet. */
  private placeNow(name: string, frame: Frame): Point | null {
    const grip = this.handles.dragging === name ? undefined : this.grips.value.get(name);
    return grip ? this.placeOfJoint(grip.joint) : placeOf(this.app.parameters.point(name), frame);
  }

  /** Draws a handle, if its place is another than before. */
  private put(name: string): void {
    const frame = this.frame(name);
    const [place, before] = [this.placeNow(name, frame), this.drawn.get(name)];
    if (!place || before?.every((value, k) => value === place[k])) return;
    this.drawn.set(name, place);
    this.handles.show(name, place, SIZE * this.height, frame.from);
  }

  /** The frame of a handle's numbers; before the actor is drawn: the stage. */
  private frame(name: string): Frame {
    const [aim, actor] = [this.aims.value.get(name), this.app.view.watched.model];
    const root = actor && aim?.isModel ? actor.rootWorld() : null;
    const isDirection = actor && aim?.kind === "direction";
    const from = isDirection ? (this.placeOfJoint(aim.joint) ?? this.middle(actor)) : null;
    return { root, from, away: AWAY * this.height };
  }

  private middle(actor: PosedModel): Point {
    return actor.position.add(new THREE.Vector3(0, this.height / 2, 0)).toArray();
  }

  private placeOfJoint(name: string): Point | null {
    const actor = this.app.view.watched.model;
    const row = actor?.cast.names.indexOf(name) ?? -1;
    if (!actor || row < 0) return null;
    const { 12: x, 13: y, 14: z } = actor.jointWorld(row);
    return [x!, y!, z!];
  }

  /** Sets the parameter of a handle that is dragged to a place in the scene. */
  private move(name: string, place: Point): void {
    const value = valueAt(place, this.frame(name));
    this.drawn.delete(name); // the ball is where the pointer is, and not where its value may be
    if (value) this.app.parameters.setPoint(name, value);
  }

  /** Takes hold of a chain, or lets it go. */
  private hold(name: string, isHeld: boolean): void {
    const grip = this.grips.value.get(name);
    if (!grip) return;
    const end = this.drawn.get(name);
    if (isHeld && end) this.move(name, end);
    this.app.parameters.set(grip.weight, isHeld ? 1 : 0);
  }

  private begin(): void {
    this.handles.clear();
    this.drawn.clear();
    this.shown.value = new Set(this.grips.value.keys());
    this.reached = new Set();
    this.looks.value = false;
    this.enter(this.app.selection.layerStates.value[0] ?? "");
  }

  private buttons(): TemplateResult {
    const buttons = [...this.aims.value].map(([name, aim]) => this.handleButtons(name, aim));
    if (canLook(this.app.machine.info.value))
      buttons.push(
        this.button("look at the pointer", "he looks where you point", this.looks.value, () => this.stare()),
      );
    this.host.hidden = !buttons.length;
    return html`${buttons}`;
  }

  /** Draws the button that shows the handle of a point, and the button that puts the point back. */
  private handleButtons(name: string, { kind, start }: Aim): TemplateResult {
    const title = `shows a handle that ${kind === "point" ? "moves the point" : "turns the direction"} ${name}`;
    const isShown = this.shown.value.has(name);
    return html`${this.button(`drag ${name}`, title, isShown, () => this.show(name, !isShown))}
    ${this.grips.value.has(name) ? nothing : this.backButton(name, start)}`;
  }

  private backButton(name: string, start: Point): TemplateResult {
    const words = `put ${name} back to where it was first`;
    const isThere = this.app.parameters.point(name).every((value, k) => Math.abs(value - start[k]!) < MOVED);
    const back = ({ currentTarget }: MouseEvent): void => {
      this.app.parameters.setPoint(name, start);
      ((currentTarget as HTMLElement).previousElementSibling as HTMLElement).focus();
    };
    return html`<button type="button" aria-label=${words} title=${words} ?hidden=${isThere} @click=${back}>
      ↺
    </button>`;
  }

  private button(words: string, title: string, isPressed: boolean, act: () => void): TemplateResult {
    return html`<button
      type="button"
      title=${title}
      aria-pressed=${isPressed}
      @click=${act}
      .textContent=${words}
    ></button>`;
  }

  /** Shows the handles of the points that the base state begins to reach for, hides those it no longer does. */
  private enter(state: string): void {
    const reached = reachedIn(this.app.machine.info.value, state);
    for (const name of this.aims.value.keys())
      if (reached.has(name) !== this.reached.has(name)) this.show(name, reached.has(name));
    this.reached = reached;
  }

  /** Shows or hides the handle of a point. */
  private show(name: string, isShown: boolean): void {
    const others = [...this.shown.value].filter((other) => other !== name);
    this.shown.value = new Set(isShown ? [...others, name] : others);
    if (!isShown) {
      this.drawn.delete(name);
      this.handles.hide(name);
    }
    this.place();
  }

  /** Puts each handle where its value is. */
  private place(): void {
    for (const name of this.shown.value) this.put(name);
  }

  /** Metres, of the character as it stood when it was drawn first. */
  private get height(): number {
    const actor = this.app.view.watched.model;
    if (actor && actor !== this.measured) {
      const { min, max } = actor.box();
      [this.measured, this.tall] = [actor, Math.max(max.y - min.y, 0.1)];
    }
    return this.tall;
  }

  /** Makes the character look at the pointer, or no more. */
  private stare(): void {
    this.looks.value = !this.looks.value;
    this.app.parameters.set(LOOK, this.looks.value ? 1 : 0);
  }

  /** Sends the place under the pointer on a plane in front of the character. */
  private follow(event: PointerEvent): void {
    const actor = this.looks.value ? this.app.view.watched.model : null;
    if (!actor) return;
    const { camera } = this.app.view.scene.view;
    const middle = new THREE.Vector3(...this.middle(actor));
    const before = camera.getWorldDirection(new THREE.Vector3()).multiplyScalar(-IN_FRONT).add(middle);
    const place = onFacingPlane(this.handles.ray(event), camera, before);
    if (place) this.app.parameters.setPoint(GAZE, place.toArray());
  }
}

export function targetsPanel(host: HTMLElement, app: App): void {
  new TargetsPanel(host, app);
}
