/**
 * Buttons for the point parameters of the watched machine: a handle to drag in the scene for each, and, for a
 * machine with `gaze` and `look`, a character that looks at the pointer.
 */

import "./targets.css";
import * as THREE from "three";
import { Latest } from "../../net/latest";
import type { MachineInfo } from "../../net/protocol";
import { canLook, GAZE, type Grip, gripsOf, LOOK, type Point, pointsOf } from "../../state/points";
import type { Session } from "../../state/session";
import { el } from "../../ui/dom";
import { onFacingPlane, PointHandles } from "../../view/pointHandles";
import type { StageView } from "../../view/stageView";

const PER_SECOND = 30;
/** Metres in front of the character at which the pointer's plane stands. */
const IN_FRONT = 1.2;
/** Metres: the size of a handle, as a part of the character's height. */
const SIZE = 0.035;

export class TargetsPanel {
  private readonly handles: PointHandles;
  private readonly points = new Map<string, Point>();
  private readonly senders = new Map<string, Latest<Point>>();
  private grips = new Map<string, Grip>();
  private shown = new Set<string>();
  /** The handles of chains that are in the scene. */
  private drawn = new Set<string>();
  private looks = false;

  constructor(
    private readonly host: HTMLElement,
    private readonly session: Session,
    private readonly stageView: StageView,
  ) {
    this.handles = new PointHandles(
      stageView.scene,
      (name, point) => this.send(name, point),
      (name, isHeld) => this.hold(name, isHeld),
    );
    const begin = (): void => this.begin(session.machine.value);
    session.machine.on(begin);
    session.actor.on(begin);
    stageView.scene.canvas.addEventListener("pointermove", (event) => this.follow(event));
  }

  /** Where each handle is drawn, in pixels; for tests. */
  places(): Record<string, [number, number]> {
    return this.handles.places();
  }

  /** Lets the handles of chains that nobody holds follow the chains' ends; called once per drawn frame. */
  update(): void {
    const actor = this.grips.size ? this.stageView.selected() : null;
    if (!actor || !this.stageView.ready.value) return;
    const places = actor.jointPositions(new Float32Array(actor.cast.joints * 3));
    for (const [name, { joint }] of this.grips) {
      const row = actor.cast.names.indexOf(joint);
      if (row < 0 || !this.shown.has(name) || this.handles.dragging === name) continue;
      const point: Point = [places[3 * row]!, places[3 * row + 1]!, places[3 * row + 2]!];
      const before = this.points.get(name);
      this.points.set(name, point);
      if (!before || !this.drawn.has(name) || before.some((value, k) => value !== point[k]))
        this.handles.show(name, point, this.size());
      this.drawn.add(name);
    }
  }

  /** Takes hold of a chain, or lets it go. */
  private hold(name: string, isHeld: boolean): void {
    const grip = this.grips.get(name);
    if (!grip) return;
    if (isHeld) this.set(name, this.points.get(name)!);
    this.set(grip.weight, isHeld ? 1 : 0);
  }

  private begin(machine: MachineInfo | null): void {
    this.handles.clear();
    this.grips = gripsOf(machine);
    this.shown = new Set(this.grips.keys());
    this.drawn = new Set();
    this.looks = false;
    this.points.clear();
    for (const [name, point] of pointsOf(machine)) this.points.set(name, point);
    this.draw(machine);
  }

  private draw(machine: MachineInfo | null): void {
    const buttons = [...this.points.keys()].map((name) =>
      this.button(`drag ${name}`, `shows a handle that moves the point ${name}`, () => this.toggle(name)),
    );
    for (const [k, name] of [...this.points.keys()].entries())
      buttons[k]!.setAttribute("aria-pressed", String(this.shown.has(name)));
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

  /** Shows or hides the handle of a point; returns whether it is shown. */
  private toggle(name: string): boolean {
    if (this.shown.delete(name)) {
      this.handles.hide(name);
      this.drawn.delete(name);
    } else {
      this.shown.add(name);
      this.handles.show(name, this.points.get(name)!, this.size());
    }
    return this.shown.has(name);
  }

  private size(): number {
    const box = this.stageView.selected()?.box();
    return SIZE * (box ? Math.max(box.max.y - box.min.y, 0.1) : 1.8);
  }

  /** Makes the character look at the pointer, or no more; returns whether it does. */
  private stare(): boolean {
    this.looks = !this.looks;
    this.set(LOOK, this.looks ? 1 : 0);
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
    if (place) this.send(GAZE, place.toArray());
  }

  /** Sets a parameter of the watched actor. */
  private set(parameter: string, value: number | Point): void {
    const actor = this.session.actor.value;
    if (actor !== null) this.session.connection.send({ type: "set", parameter, value, actor });
  }

  private send(name: string, point: Point): void {
    this.points.set(name, point);
    if (this.shown.has(name)) this.handles.show(name, point, this.size());
    let sender = this.senders.get(name);
    if (!sender) {
      sender = new Latest<Point>((newest) => this.set(name, newest), PER_SECOND);
      this.senders.set(name, sender);
    }
    sender.put(point);
  }
}
