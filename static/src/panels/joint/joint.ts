/**
 * The joint that you click in the scene: its degrees of freedom, their values and limits; and the handles at joints
 * whose degrees of freedom parameters move.
 */

import "./joint.css";
import { effect, signal } from "@preact/signals-core";
import * as THREE from "three";
import type { JointLimit, MachineInfo } from "../../net/protocol";
import type { App } from "../../view/app";
import { byId, el, say } from "../../ui/dom";
import { type Handle, handlesOf, JointHandles } from "../../view/jointHandles";
import { freedomValues, type Local, valueWords } from "../../view/jointValues";
import type { LimitMark } from "../../view/limitOverlay";
import { JointPlot } from "./jointPlot";
import { JointTrack } from "./jointTrack";
import { jointWords, turnsOf } from "./pose";
import { PoseTrial } from "./poseTrial";

/** Pixels from a circle within which a click chooses its joint, and by which a click may move. */
const [NEAR, STILL] = [14, 4];

/** Returns a degree of freedom in words: `angle 34.2° (-80.0° … 80.0°)`. */
export function freedomWords(freedom: JointLimit["freedoms"][number], value: number): string {
  const { name, is_angle, minimum, maximum } = freedom;
  const end = (at: number | null): string => (at === null ? "free" : valueWords(at, is_angle));
  const range = minimum === null && maximum === null ? "free" : `${end(minimum)} … ${end(maximum)}`;
  return `${name.replace("_", " ")} ${valueWords(value, is_angle)} (${range})`;
}

class JointPanel {
  private readonly handles: JointHandles;
  private readonly label = el("div", { class: "joint-value", hidden: true });
  private readonly line = el("p", { class: "joint-line" });
  private readonly track = new JointTrack();
  private readonly plot = new JointPlot(this.track);
  private down: [number, number] | null = null;

  constructor(
    private readonly host: HTMLElement,
    private readonly app: App,
  ) {
    const { scene } = app.view;
    const { canvas } = scene;
    this.handles = new JointHandles(
      scene,
      (handle) => this.take(handle),
      (handle, values) => this.move(handle, values),
    );
    canvas.after(this.label);
    host.append(this.line, this.tools(), this.plot.box);
    canvas.addEventListener("pointerdown", (event) => {
      this.down = event.button === 0 && !this.handles.busy ? [event.clientX, event.clientY] : null;
    });
    canvas.addEventListener("pointerup", (event) => this.click(event));
  }

  /** Makes the buttons that plot the joint's turns and draw its path. */
  private tools(): HTMLElement {
    const { traced, joint } = this.app.view.watched;
    const isPlotted = signal(false);
    const plot = el("button", { type: "button", title: "its turns from its parent, over time" }, "plot");
    plot.addEventListener("click", () => (isPlotted.value = !isPlotted.value));
    isPlotted.subscribe((on) => plot.setAttribute("aria-pressed", String(on)));
    effect(() => void this.plot.show(isPlotted.value && joint.value !== ""));
    const path = el("button", { type: "button", title: "draw the line through its latest places" }, "path");
    path.addEventListener("click", () => (traced.value = traced.value === joint.value ? "" : joint.value));
    effect(() => path.setAttribute("aria-pressed", String(!!joint.value && traced.value === joint.value)));
    const tools = el("div", { class: "joint-tools" }, plot, path);
    joint.subscribe((name) => (tools.hidden = !name));
    return tools;
  }

  /** Whether handles move the chosen joint. */
  get hasHandles(): boolean {
    return !this.handles.isEmpty;
  }

  /** Follows the pose; called once per drawn frame. */
  update(now: number): void {
    this.record();
    this.plot.update(now, this.app.stage.rate);
    const machine = this.app.machine.info.value;
    const marks = this.app.view.watched.marks();
    const wanted = marks.flatMap((mark) => this.wanted(mark, machine));
    this.handles.show(wanted);
    const values = wanted.flatMap(({ handle, values }) =>
      handle.parameters.map(({ name }, k) => [name, values[k]!] as const),
    );
    this.tell(marks, new Map([...values, ...this.handles.held()]), machine);
  }

  /** Notes the turns of the picked joint. */
  private record(): void {
    const { view } = this.app;
    const actor = view.watched.model;
    const joint = actor?.cast.names.indexOf(view.watched.joint.value) ?? -1;
    const local = actor?.local(joint);
    if (local) this.track.add(`${actor!.id} ${joint}`, view.posed, turnsOf(local.quaternion));
  }

  private wanted(
    mark: LimitMark,
    machine: MachineInfo | null,
  ): { handle: Handle; mark: LimitMark; values: number[] }[] {
    const now = freedomValues(mark.limit, mark.local);
    return handlesOf(mark.limit, machine?.parameters ?? []).map((handle) => ({
      handle,
      mark,
      values: handle.parameters.map(({ freedom }) => now.get(freedom) ?? 0),
    }));
  }

  /** Says the values of the chosen joint, or of the only one with limits. */
  private tell(
    marks: readonly LimitMark[],
    held: ReadonlyMap<string, number>,
    machine: MachineInfo | null,
  ): void {
    const chosen = this.app.view.watched.joint.value;
    const mark = marks.length === 1 ? marks[0] : undefined;
    this.host.hidden = !chosen && !mark;
    if (this.host.hidden) return this.hideLabel();
    const words = mark ? this.words(mark.limit, mark.local, held, machine) : ["no limits"];
    const actor = this.app.view.watched.model;
    const pose = actor && chosen ? jointWords(actor, actor.cast.names.indexOf(chosen)) : [];
    const name = `${chosen || mark!.limit.joint}${mark?.limit.symbol ? ` · ${mark.limit.symbol}` : ""}`;
    const parts = [name, ...words, ...pose];
    if (this.line.children.length !== parts.length)
      this.line.replaceChildren(...parts.map((_, k) => el(k ? "span" : "strong")));
    parts.forEach((part, k) => say(this.line.children[k]!, part));
    this.follow(words);
  }

  private words(
    limit: JointLimit,
    local: Local,
    held: ReadonlyMap<string, number>,
    machine: MachineInfo | null,
  ): string[] {
    const now = freedomValues(limit, local);
    return limit.freedoms.map((freedom) => {
      const parameter = machine?.parameters.find(
        ({ joint, freedom: moved }) => joint === limit.joint && moved === freedom.name,
      );
      return freedomWords(freedom, (parameter && held.get(parameter.name)) ?? now.get(freedom.name) ?? 0);
    });
  }

  /** Puts the values of the handle that is dragged beside it. */
  private follow(words: readonly string[]): void {
    const held = this.handles.heldKey();
    const place = held === null ? undefined : this.handles.places()[held];
    if (!place) return this.hideLabel();
    const box = this.app.view.scene.canvas.getBoundingClientRect();
    const moved = this.handles.heldFreedoms();
    say(this.label, words.filter((part) => moved.some((name) => part.startsWith(`${name} `))).join(", "));
    this.label.hidden = false;
    this.label.style.transform = `translate(${Math.round(place[0] - box.left + 16)}px, ${Math.round(place[1] - box.top - 30)}px)`;
  }

  private hideLabel(): void {
    this.label.hidden = true;
  }

  /** Chooses the joint whose circle is under the pointer; beside all circles none, or the actor there. */
  private click(event: PointerEvent): void {
    const { down } = this;
    this.down = null;
    if (!down || Math.hypot(event.clientX - down[0], event.clientY - down[1]) > STILL) return;
    const found = this.nearest(event);
    if (found === null && !this.app.view.watched.joint.value) return this.chooseActor(event);
    this.app.view.watched.joint.value = found === this.app.view.watched.joint.value ? "" : (found ?? "");
  }

  private chooseActor({ clientX, clientY }: PointerEvent): void {
    const actor = this.app.view.actorAt(clientX, clientY);
    if (actor === null || actor === this.app.selection.actor.value) return;
    void this.app.machine.choose(actor);
  }

  private nearest(event: PointerEvent): string | null {
    const { scene } = this.app.view;
    const actor = this.app.view.watched.model;
    if (!actor) return null;
    const box = scene.canvas.getBoundingClientRect();
    const places = actor.jointPositions(new Float32Array(actor.cast.joints * 3));
    let [best, away]: [string | null, number] = [null, NEAR];
    for (const name of this.app.view.watched.circles()) {
      const joint = actor.cast.names.indexOf(name);
      const { x, y } = new THREE.Vector3().fromArray(places, joint * 3).project(scene.view.camera);
      const left = box.left + ((x + 1) / 2) * box.width - event.clientX;
      const far = Math.hypot(left, box.top + ((1 - y) / 2) * box.height - event.clientY);
      if (far < away) [best, away] = [name, far];
    }
    return best;
  }

  private take({ parameters }: Handle): void {
    const events = new Set(parameters.map(({ event }) => event).filter(Boolean));
    for (const event of events) this.app.session.event("press", event);
  }

  private move({ parameters }: Handle, values: readonly number[]): void {
    parameters.forEach(({ name }, k) => this.app.parameters.set(name, values[k]!));
  }
}

export function jointPanel(host: HTMLElement, app: App): void {
  const joint = new JointPanel(host, app);
  const trial = new PoseTrial(byId("trial"), app);
  app.frame.on(({ now }) => {
    joint.update(now);
    trial.update(joint.hasHandles);
  });
}
