/**
 * Buttons for the point parameters of the watched machine: a handle to drag in the scene for each, and, for a
 * machine with `gaze` and `look`, a character that looks at the pointer. The handle of a target shows by itself in
 * states in which a solver reaches for it.
 */

import "./targets.css";
import * as THREE from "three";
import type { MachineInfo } from "../../net/protocol";
import type { ParameterValues } from "../../state/parameterValues";
import { canLook, GAZE, LOOK, pointsOf, reachedIn } from "../../state/points";
import type { Session } from "../../state/session";
import { el } from "../../ui/dom";
import { onFacingPlane, PointHandles } from "../../view/pointHandles";
import type { StageView } from "../../view/stageView";

/** Metres in front of the character at which the pointer's plane stands. */
const IN_FRONT = 1.2;
/** Metres: the size of a handle, as a part of the character's height. */
const SIZE = 0.035;

export class TargetsPanel {
  private readonly handles: PointHandles;
  private readonly buttons = new Map<string, HTMLButtonElement>();
  private shown = new Set<string>();
  private reached = new Set<string>();
  private looks = false;

  constructor(
    private readonly host: HTMLElement,
    private readonly session: Session,
    private readonly stageView: StageView,
    private readonly values: ParameterValues,
  ) {
    this.handles = new PointHandles(stageView.scene, (name, point) => values.setPoint(name, point));
    const begin = (): void => this.begin(session.machine.value);
    session.machine.on(begin);
    session.actor.on(begin);
    session.layerStates.on(([base]) => this.enter(base ?? ""));
    values.changed.on(() => this.place());
    stageView.scene.canvas.addEventListener("pointermove", (event) => this.follow(event));
  }

  /** Where each handle is drawn, in pixels; for tests. */
  places(): Record<string, [number, number]> {
    return this.handles.places();
  }

  private begin(machine: MachineInfo | null): void {
    this.handles.clear();
    this.shown = new Set();
    this.reached = new Set();
    this.looks = false;
    this.draw(machine);
    this.enter(this.session.layerStates.value[0] ?? "");
  }

  private draw(machine: MachineInfo | null): void {
    this.buttons.clear();
    for (const name of pointsOf(machine).keys()) {
      const title = `shows a handle that moves the point ${name}`;
      this.buttons.set(
        name,
        this.button(`drag ${name}`, title, () => this.show(name, !this.shown.has(name))),
      );
    }
    const buttons = [...this.buttons.values()];
    if (canLook(machine))
      buttons.push(this.button("look at the pointer", "he looks where you point", () => this.stare()));
    this.host.hidden = !buttons.length;
    this.host.replaceChildren(...buttons);
  }

  private button(words: string, title: string, act: () => boolean): HTMLButtonElement {
    const made = el("button", { type: "button", title, "aria-pressed": "false" }, words);
    made.addEventListener("click", () => made.setAttribute("aria-pressed", String(act())));
    return made;
  }

  /** Shows the handles of the points that the base state begins to reach for, hides those it no longer does. */
  private enter(state: string): void {
    const reached = reachedIn(this.session.machine.value, state);
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
      this.handles.hide(name);
    }
    this.place();
    return isShown;
  }

  /** Puts the handles where their points are. */
  private place(): void {
    for (const name of this.shown) this.handles.show(name, this.values.point(name), this.size());
  }

  private size(): number {
    const box = this.stageView.selected()?.box();
    return SIZE * (box ? Math.max(box.max.y - box.min.y, 0.1) : 1.8);
  }

  /** Makes the character look at the pointer, or no more; returns whether it does. */
  private stare(): boolean {
    this.looks = !this.looks;
    this.values.set(LOOK, this.looks ? 1 : 0);
    return this.looks;
  }

  /** Sends the place under the pointer on a plane in front of the character. */
  private follow(event: PointerEvent): void {
    const actor = this.looks ? this.stageView.selected() : null;
    if (!actor) return;
    const { camera } = this.stageView.scene.view;
    const centre = actor.box().getCenter(new THREE.Vector3());
    const before = camera.getWorldDirection(new THREE.Vector3()).multiplyScalar(-IN_FRONT).add(centre);
    const place = onFacingPlane(this.handles.ray(event), camera, before);
    if (place) this.values.setPoint(GAZE, place.toArray());
  }
}
