/** Who is watched: the stage's casts, the actor chosen among them, its machine, its state, and what was seen of it. */

import { Happenings } from "./happenings";
import { History, lineOf } from "./history";
import type { CastHello, Hello, LayerInfo, MachineInfo, StateHistory } from "./net/protocol";
import type { CastFrame } from "./net/wire";
import { Signal } from "./store";

export interface Place {
  cast: number;
  row: number;
}

export class Watched {
  readonly hello = new Signal<Hello | null>(null);
  readonly machine = new Signal<MachineInfo | null>(null);
  /** The id of the watched actor. */
  readonly actor = new Signal<number | null>(null);
  /** The state of the watched actor, an index into its cast's states. */
  readonly state = new Signal<number | null>(null);
  /** The state in every layer of the watched actor, by name. */
  readonly layerStates = new Signal<readonly string[]>([]);
  /** The layer that table and graph show. */
  readonly layer = new Signal(0);
  readonly history = new History();
  readonly happenings = new Happenings();

  get cast(): CastHello | null {
    const place = this.place();
    return (place && this.hello.value?.casts[place.cast]) ?? null;
  }

  /** What the machine says of the layer that is shown. */
  get layerInfo(): LayerInfo | null {
    const layers = this.machine.value?.layers ?? [];
    return layers[this.layer.value] ?? layers[0] ?? null;
  }

  /** The state of the watched actor in the layer that is shown. */
  get shownState(): string {
    return this.layerStates.value[this.layer.value] ?? "";
  }

  /** The states of the watched actor by layer, told where they are others than before. */
  protected tellStates(states: readonly string[]): void {
    if (states.join() !== this.layerStates.value.join()) this.layerStates.set(states);
  }

  /** Every actor of cast number `c` is where the frame says. */
  protected remember(tick: number, { state, layers }: CastFrame, c: number): void {
    const told = this.hello.value?.casts[c];
    told?.actors.forEach(({ id }, row) => {
      for (let layer = 0; layer < layers; layer++) this.history.see(lineOf(id, layer), tick, told.states[state[row * layers + layer]!] ?? "");
    });
  }

  protected showStates({ state, layers }: CastFrame, row: number): void {
    const own = [...state.subarray(row * layers, (row + 1) * layers)];
    this.state.set(own[0] ?? null);
    this.tellStates(own.map((index) => this.stateName(index)));
  }

  /** A verdict says that a layer of the watched actor is in `state` now. */
  protected leads(layer: number, index: number, state: string): void {
    this.tellStates((this.cast?.layers ?? []).map((_, l) => (l === layer ? state : (this.layerStates.value[l] ?? ""))));
    if (layer === 0) this.state.set(index);
  }

  /** Ticks from `from` to `to` in which something became of `actor`: it entered a state, or an event was judged. */
  happened(actor: number, from: number, to: number): number[] {
    const layers = this.cast?.layers ?? [];
    const entered = layers.flatMap((_, layer) => this.history.between(lineOf(actor, layer), from, to).map((run) => run.start));
    const judged = this.happenings.marksBetween(actor, from, to).filter(({ kind }) => kind !== "logged").map((mark) => mark.tick);
    return [...entered.filter((tick) => tick >= from), ...judged];
  }

  /** Where the watched actor stands in the frames. */
  place(actor: number | null = this.actor.value): Place | null {
    const casts = this.hello.value?.casts ?? [];
    for (let cast = 0; cast < casts.length; cast++) {
      const row = casts[cast]!.actors.findIndex(({ id }) => id === actor);
      if (row >= 0) return { cast, row };
    }
    return null;
  }

  /** Takes over what the server knows of the past of stage `stage`, if that is still watched. */
  protected recall(stage: string, { head, changes }: StateHistory): void {
    if (stage !== this.hello.value?.stage) return;
    const lines = new Map<number, { tick: number; state: string }[]>();
    for (const { actor, layer, tick, state } of changes) {
      const line = lineOf(actor, layer);
      if (lines.get(line)?.push({ tick, state }) === undefined) lines.set(line, [{ tick, state }]);
    }
    lines.forEach((known, line) => this.history.fill(line, known, head));
  }

  /** The index of a state of a layer of `actor`, or -1. */
  stateIndex(actor: number, name: string, layer = 0): number {
    const place = this.place(actor);
    const cast = place && this.hello.value!.casts[place.cast]!;
    return cast ? cast.states.findIndex((state, i) => state === name && cast.state_layers[i] === layer) : -1;
  }

  /** The name of a state of the watched actor. */
  stateName(index: number | null): string {
    return (index !== null && this.cast?.states[index]) || "";
  }
}
