/** Holds the stage's casts, the watched actor, its machine, its states and its history. */

import { EventLog } from "./eventLog";
import { History, laneKey } from "./history";
import type { CastHello, Hello, LayerInfo, MachineInfo, StateHistory } from "../net/protocol";
import type { CastFrame } from "../net/wire";
import { Signal } from "./signal";

export interface FrameRow {
  cast: number;
  row: number;
}

export class ActorSelection {
  readonly hello = new Signal<Hello | null>(null);
  readonly machine = new Signal<MachineInfo | null>(null);
  /** The id of the watched actor. */
  readonly actor = new Signal<number | null>(null);
  /** The watched actor's state in the base layer, an index into its cast's states. */
  readonly state = new Signal<number | null>(null);
  /** The watched actor's state in every layer, by name. */
  readonly layerStates = new Signal<readonly string[]>([]);
  /** The layer that table and graph show. */
  readonly layer = new Signal(0);
  readonly history = new History();
  readonly eventLog = new EventLog();

  get cast(): CastHello | null {
    const place = this.place();
    return (place && this.hello.value?.casts[place.cast]) ?? null;
  }

  /** The shown layer of the machine. */
  get layerInfo(): LayerInfo | null {
    const layers = this.machine.value?.layers ?? [];
    return layers[this.layer.value] ?? layers[0] ?? null;
  }

  /** The watched actor's state in the shown layer. */
  get shownState(): string {
    return this.layerStates.value[this.layer.value] ?? "";
  }

  protected tellStates(states: readonly string[]): void {
    if (states.join() !== this.layerStates.value.join()) this.layerStates.set(states);
  }

  /** Enters the states of every actor of cast number `c` into the history. */
  protected remember(tick: number, { state, layers }: CastFrame, c: number): void {
    const cast = this.hello.value?.casts[c];
    cast?.actors.forEach(({ id }, row) => {
      for (let layer = 0; layer < layers; layer++)
        this.history.see(laneKey(id, layer), tick, cast.states[state[row * layers + layer]!] ?? "");
    });
  }

  protected showStates({ state, layers }: CastFrame, row: number): void {
    const rowStates = [...state.subarray(row * layers, (row + 1) * layers)];
    this.state.set(rowStates[0] ?? null);
    this.tellStates(rowStates.map((index) => this.stateName(index)));
  }

  /** Sets the state of one layer of the watched actor, as a verdict says. */
  protected leads(layer: number, index: number, state: string): void {
    this.tellStates(
      (this.cast?.layers ?? []).map((_, l) => (l === layer ? state : (this.layerStates.value[l] ?? ""))),
    );
    if (layer === 0) this.state.set(index);
  }

  /** Ticks from `from` to `to` in which `actor` entered a state or got a verdict. */
  happened(actor: number, from: number, to: number): number[] {
    const layers = this.cast?.layers ?? [];
    const entered = layers.flatMap((_, layer) =>
      this.history.between(laneKey(actor, layer), from, to).map((run) => run.start),
    );
    const judged = this.eventLog
      .marksBetween(actor, from, to)
      .filter(({ kind }) => kind !== "logged")
      .map((mark) => mark.tick);
    return [...entered.filter((tick) => tick >= from), ...judged];
  }

  /** Returns the cast and row of an actor in the frames, or null. */
  place(actor: number | null = this.actor.value): FrameRow | null {
    const casts = this.hello.value?.casts ?? [];
    for (let cast = 0; cast < casts.length; cast++) {
      const row = casts[cast]!.actors.findIndex(({ id }) => id === actor);
      if (row >= 0) return { cast, row };
    }
    return null;
  }

  /** Enters the server's state changes into the history, if `stage` is still watched. */
  protected recall(stage: string, { head, changes }: StateHistory): void {
    if (stage !== this.hello.value?.stage) return;
    const lanes = new Map<number, { tick: number; state: string }[]>();
    for (const { actor, layer, tick, state } of changes) {
      const lane = laneKey(actor, layer);
      if (lanes.get(lane)?.push({ tick, state }) === undefined) lanes.set(lane, [{ tick, state }]);
    }
    lanes.forEach((known, lane) => this.history.fill(lane, known, head));
  }

  /** Returns the index of a state of a layer of `actor`, or -1. */
  stateIndex(actor: number, name: string, layer = 0): number {
    const place = this.place(actor);
    const cast = place && this.hello.value!.casts[place.cast]!;
    return cast ? cast.states.findIndex((state, i) => state === name && cast.state_layers[i] === layer) : -1;
  }

  /** Returns the name of one of the watched actor's states, "" if there is none. */
  stateName(index: number | null): string {
    return (index !== null && this.cast?.states[index]) || "";
  }
}
