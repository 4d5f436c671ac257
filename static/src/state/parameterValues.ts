/** The parameters of the watched actor as they are set: the server's values at first, then what this page sets. */

import { actorFacts } from "../net/actors";
import { Latest } from "../net/latest";
import type { MachineInfo, Parameter } from "../net/protocol";
import type { Point } from "./points";
import { Event } from "./event";
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
  /** Emitted with the name of a parameter that has a new value, or with null: all of them may have. */
  readonly changed = new Event<string | null>();
  private values = new Map<string, number>();
  private readonly senders = new Map<string, Latest<() => void>>();
  private machine: MachineInfo | null = null;
  private turn = 0;

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
    return this.values.get(name) ?? 0;
  }

  point(name: string): Point {
    return [this.get(`${name}.x`), this.get(`${name}.y`), this.get(`${name}.z`)];
  }

  /** Sets a number; a component of a point goes out with the whole point. */
  set(name: string, value: number): void {
    const parameter = this.machine?.parameters.find((known) => known.name === name);
    if (!parameter) return;
    this.values.set(name, within(parameter, value));
    const whole = parameter.vector || name;
    this.changed.emit(whole);
    this.send(whole, parameter.vector ? () => this.point(whole) : () => this.get(name));
  }

  setPoint(name: string, point: Point): void {
    for (const parameter of this.machine?.parameters ?? [])
      if (parameter.vector === name)
        this.values.set(parameter.name, within(parameter, point["xyz".indexOf(parameter.name.slice(-1))]!));
    this.changed.emit(name);
    this.send(name, () => this.point(name));
  }

  /** Begins with the defaults. */
  private learn(machine: MachineInfo | null): void {
    this.machine = machine;
    this.take(new Map((machine?.parameters ?? []).map(({ name, default: value }) => [name, value])));
    void this.read();
  }

  /** Takes what the server says. */
  private async read(): Promise<void> {
    const turn = ++this.turn;
    const actor = this.selection.actor.value;
    if (actor === null || !this.machine?.parameters.length) return;
    const facts = await actorFacts(this.stage.id, actor).catch(() => null);
    if (!facts || turn !== this.turn || facts.machine !== this.machine.name) return;
    const known = Object.entries(facts.parameters).flatMap(([name, value]): [string, number][] =>
      Array.isArray(value)
        ? value.map((number, place) => [`${name}.${"xyzw"[place]}`, number])
        : [[name, value]],
    );
    this.take(new Map(known));
  }

  private take(values: Map<string, number>): void {
    this.values = values;
    this.changed.emit(null);
  }

  private send(whole: string, value: () => number | Point): void {
    const actor = this.selection.actor.value;
    if (actor === null) return;
    let sender = this.senders.get(whole);
    if (!sender) this.senders.set(whole, (sender = new Latest<() => void>((now) => now(), PER_SECOND)));
    sender.put(() => this.line.send({ type: "set", parameter: whole, value: value(), actor }));
  }
}
