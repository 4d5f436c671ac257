/**
 * Buttons for the point parameters of the watched machine: a handle to drag in the scene for each, and, for a
 * machine with `gaze` and `look`, a character that looks at the pointer. The handle of a target shows by itself in
 * states in which a solver reaches for it; the handle of a chain that you take hold of is at the chain's free end.
 */

import "./targets.css";
import * as THREE from "three";
import type { MachineInfo } from "../../net/protocol";
import { canLook, GAZE, type Grip, gripsOf, LOOK, type Point, pointsOf, reachedIn } from "../../state/points";
import type { App } from "../../view/app";
import { el } from "../../ui/dom";
import { onFacingPlane, PointHandles } from "../../view/pointHandles";

/** Metres in front of the character at which the pointer's plane stands. */
const IN_FRONT = 1.2;
/** Metres: the size of a handle, as a part of the character's height. */
const SIZE = 0.035;
/** Metres: a point that is nearer to its first place counts as being there. */
const MOVED = 1e-5;

class TargetsPanel {
  private readonly handles: PointHandles;
  private readonly buttons = new Map<string, HTMLButtonElement>();
  /** Where each point was first, and the button that puts it back there. */
  private readonly backs = new Map<string, { start: Point; button: HTMLButtonElement }>();
  private shown = new Set<string>();
  private reached = new Set<string>();
  private grips = new Map<string, Grip>();
  /** The free ends of the grips' chains, as they are drawn. */
  private readonly ends = new Map<string, Point>();
  private looks = false;

  constructor(
    private readonly host: HTMLElement,
    private readonly app: App,
  ) {
    const { scene } = app.view;
    this.handles = new PointHandles(
      scene,
      (name, point) => app.parameters.setPoint(name, point),
      (name, isHeld) => this.hold(name, isHeld),
    );
    const begin = (): void => this.begin(app.machine.info.value);
    app.machine.info.subscribe(begin);
    app.selection.actor.subscribe(begin);
    app.selection.layerStates.subscribe(([base]) => this.enter(base ?? ""));
    app.parameters.all.subscribe(() => this.place());
    scene.canvas.addEventListener("pointermove", (event) => this.follow(event));
    app.frame.on(() => this.update());
  }

  /** Lets the handles of chains that nobody holds follow the chains' ends. */
  private update(): void {
    const actor = this.grips.size ? this.app.view.watched.model : null;
    if (!actor || !this.app.view.watched.ready.value) return;
    const places = actor.jointPositions(new Float32Array(actor.cast.joints * 3));
    for (const [name, { joint }] of this.grips) {
      const row = actor.cast.names.indexOf(joint);
      if (row < 0 || !this.shown.has(name) || this.handles.dragging === name) continue;
      const end: Point = [places[3 * row]!, places[3 * row + 1]!, places[3 * row + 2]!];
      const before = this.ends.get(name);
      this.ends.set(name, end);
      if (!before || before.some((value, k) => value !== end[k])) this.handles.show(name, end, this.size());
    }
  }

  /** Takes hold of a chain, or lets it go. */
  private hold(name: string, isHeld: boolean): void {
    const grip = this.grips.get(name);
    if (!grip) return;
    const end = this.ends.get(name);
    if (isHeld && end) this.app.parameters.setPoint(name, end);
    this.app.parameters.set(grip.weight, isHeld ? 1 : 0);
  }

  private begin(machine: MachineInfo | null): void {
    this.handles.clear();
    this.grips = gripsOf(machine);
    this.ends.clear();
    this.shown = new Set(this.grips.keys());
    this.reached = new Set();
    this.looks = false;
    this.draw(machine);
    this.enter(this.app.selection.layerStates.value[0] ?? "");
  }

  private draw(machine: MachineInfo | null): void {
    this.buttons.clear();
    this.backs.clear();
    const buttons: HTMLElement[] = [];
    for (const [name, start] of pointsOf(machine)) {
      const title = `shows a handle that moves the point ${name}`;
      const drag = this.button(`drag ${name}`, title, () => this.show(name, !this.shown.has(name)));
      drag.setAttribute("aria-pressed", String(this.shown.has(name)));
      this.buttons.set(name, drag);
      buttons.push(drag);
      if (!this.grips.has(name)) buttons.push(this.backButton(name, start));
    }
    if (canLook(machine))
      buttons.push(this.button("look at the pointer", "he looks where you point", () => this.stare()));
    this.host.hidden = !buttons.length;
    this.host.replaceChildren(...buttons);
  }

  private backButton(name: string, start: Point): HTMLButtonElement {
    const words = `put ${name} back to where it was first`;
    const made = el("button", { type: "button", "aria-label": words, title: words, hidden: true }, "↺");
    made.addEventListener("click", () => {
      this.app.parameters.setPoint(name, start);
      this.buttons.get(name)?.focus();
    });
    this.backs.set(name, { start, button: made });
    return made;
  }

  private button(words: string, title: string, act: () => boolean): HTMLButtonElement {
    const made = el("button", { type: "button", title, "aria-pressed": "false" }, words);
    made.addEventListener("click", () => made.setAttribute("aria-pressed", String(act())));
    return made;
  }

  /** Shows the handles of the points that the base state begins to reach for, hides those it no longer does. */
  private enter(state: string): void {
    const reached = reachedIn(this.app.machine.info.value, state);
    for (const name of this.buttons.keys())
      if (reached.has(name) !== this.reached.has(name)) {
        this.show(name, reached.has(name));
        this.buttons.get(name)?.setAttribute("aria-pressed", String(reached.has(name)));
      }
    this.reached = reached;
  }

  /** Shows or hides the handle of a point; returns whether it is shown. */
  private show(name: string, isShown: boolean): boolean {
    if (isShown) this.shown.add(name);
    else {
      this.shown.delete(name);
      this.ends.delete(name);
      this.handles.hide(name);
    }
    this.place();
    return isShown;
  }

  /** Puts each handle where its point is, but for chains that nobody holds; shows the buttons that put points back. */
  private place(): void {
    for (const name of this.shown)
      if (!this.grips.has(name) || this.handles.dragging === name)
        this.handles.show(name, this.app.parameters.point(name), this.size());
    for (const [name, { start, button }] of this.backs) {
      const point = this.app.parameters.point(name);
      button.hidden = point.every((value, k) => Math.abs(value - start[k]!) < MOVED);
    }
  }

  private size(): number {
    const box = this.app.view.watched.model?.box();
    return SIZE * (box ? Math.max(box.max.y - box.min.y, 0.1) : 1.8);
  }

  /** Makes the character look at the pointer, or no more; returns whether it does. */
  private stare(): boolean {
    this.looks = !this.looks;
    this.app.parameters.set(LOOK, this.looks ? 1 : 0);
    return this.looks;
  }

  /** Sends the place under the pointer on a plane in front of the character. */
  private follow(event: PointerEvent): void {
    const actor = this.looks ? this.app.view.watched.model : null;
    if (!actor) return;
    const { camera } = this.app.view.scene.view;
    const centre = actor.box().getCenter(new THREE.Vector3());
    const before = camera.getWorldDirection(new THREE.Vector3()).multiplyScalar(-IN_FRONT).add(centre);
    const place = onFacingPlane(this.handles.ray(event), camera, before);
    if (place) this.app.parameters.setPoint(GAZE, place.toArray());
  }
}

export function targetsPanel(host: HTMLElement, app: App): void {
  new TargetsPanel(host, app);
}
