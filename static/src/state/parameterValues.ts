/** The parameters of the watched actor as they are set: the server's values at first, then what this page sets. */

import { signal } from "@preact/signals-core";
import { actorFacts } from "../net/actors";
import { Latest } from "../net/latest";
import type { MachineInfo, Parameter } from "../net/protocol";
import type { Point } from "./points";
import type { Line } from "./line";
import type { Selection } from "./selection";
import type { WatchedMachine } from "./watchedMachine";
import type { WatchedStage } from "./watchedStage";

const PER_SECOND = 30;

/** Returns a value within the range of a parameter. */
export function within({ minimum, maximum }: Parameter, value: number): number {
  return Math.min(maximum, Math.max(minimum, value));
}

export class ParameterValues {
  /** The numbers, and the components of points, directions and rotations as `target.x`, by name. */
  readonly all = signal<ReadonlyMap<string, number>>(new Map());
  private readonly senders = new Map<string, Latest<() => void>>();
  private machine: MachineInfo | null = null;
  private turn = 0;
  /** What this page has set since it asked the server: the answer may be older. */
  private readonly touched = new Set<string>();

  constructor(
    private readonly line: Line,
    private readonly stage: WatchedStage,
    private readonly selection: Selection,
    machine: WatchedMachine,
  ) {
    machine.info.subscribe((info) => this.learn(info));
    selection.actor.subscribe(() => void this.read());
    stage.hello.subscribe(() => void this.read());
  }

  /** Returns the value of a number, or of a component of a point as `target.x`. */
  get(name: string): number {
    return this.all.value.get(name) ?? 0;
  }

  point(name: string): Point {
    return [this.get(`${name}.x`), this.get(`${name}.y`), this.get(`${name}.z`)];
  }

  /** Sets a number; a component of a point, a direction or a rotation goes out with the others. */
  set(name: string, value: number): void {
    const parameter = this.machine?.parameters.find((known) => known.name === name);
    if (!parameter) return;
    this.take([[name, within(parameter, value)]]);
    const whole = parameter.vector || name;
    this.send(whole, parameter.vector ? () => this.vector(whole) : () => this.get(name));
  }

  setPoint(name: string, point: Point): void {
    const parts = (this.machine?.parameters ?? []).filter(({ vector }) => vector === name);
    this.take(parts.map((part) => [part.name, within(part, point["xyz".indexOf(part.name.slice(-1))]!)]));
    this.send(name, () => this.point(name));
  }

  /** The components of a point, a direction or a rotation. */
  private vector(name: string): number[] {
    const parts = (this.machine?.parameters ?? []).filter(({ vector }) => vector === name);
    return parts.map((part) => this.get(part.name));
  }

  /** Begins with the defaults. */
  private learn(machine: MachineInfo | null): void {
    this.machine = machine;
    this.all.value = new Map((machine?.parameters ?? []).map(({ name, default: value }) => [name, value]));
    void this.read();
  }

  /** Takes what the server says. */
  private async read(): Promise<void> {
    const turn = ++this.turn;
    this.touched.clear();
    const actor = this.selection.actor.value;
    if (actor === null || !this.machine?.parameters.length) return;
    const facts = await actorFacts(this.stage.id, actor).catch(() => null);
    if (!facts || turn !== this.turn || facts.machine !== this.machine.name) return;
    const known = Object.entries(facts.parameters).flatMap(([name, value]): [string, number][] =>
      Array.isArray(value)
        ? value.map((number, place) => [`${name}.${"xyzw"[place]}`, number])
        : [[name, value]],
    );
    const own = [...this.all.value].filter(([name]) => this.touched.has(name));
    this.all.value = new Map([...known, ...own]);
  }

  private take(values: readonly (readonly [string, number])[]): void {
    for (const [name] of values) this.touched.add(name);
    this.all.value = new Map([...this.all.value, ...values]);
  }

  private send(whole: string, value: () => number | number[]): void {
    const actor = this.selection.actor.value;
    if (actor === null) return;
    let sender = this.senders.get(whole);
    if (!sender) this.senders.set(whole, (sender = new Latest<() => void>((now) => now(), PER_SECOND)));
    sender.put(() => this.line.send({ type: "set", parameter: whole, value: value(), actor }));
  }
}
