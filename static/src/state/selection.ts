/** The watched actor with its states, and the layer that table and graph show. */

import { signal } from "@preact/signals-core";
import type { CastHello } from "../net/protocol";
import type { CastFrame } from "../net/wire";
import type { WatchedStage } from "./watchedStage";

export interface FrameRow {
  cast: number;
  row: number;
}

export class Selection {
  /** The id of the watched actor. */
  readonly actor = signal<number | null>(null);
  /** The watched actor's state in the base layer, an index into its cast's states. */
  readonly state = signal<number | null>(null);
  /** The watched actor's state in every layer, by name. */
  readonly layerStates = signal<readonly string[]>([]);
  readonly layer = signal(0);

  constructor(private readonly stage: WatchedStage) {}

  get cast(): CastHello | null {
    const place = this.place();
    return (place && this.stage.hello.value?.casts[place.cast]) ?? null;
  }

  /** The watched actor's state in the shown layer. */
  get shownState(): string {
    return this.layerStates.value[this.layer.value] ?? "";
  }

  /** Watches the first actor if the stage has no watched one. */
  settle(): void {
    if (!this.place()) this.actor.value = this.stage.firstActor;
  }

  forgetStates(): void {
    this.state.value = null;
    this.tellStates([]);
  }

  /** Takes the states of all layers, by name. */
  tellStates(states: readonly string[]): void {
    if (states.join() !== this.layerStates.value.join()) this.layerStates.value = states;
  }

  /** Takes the states of the watched actor, row `row` of a frame. */
  showStates({ state, layers }: CastFrame, row: number): void {
    const rowStates = [...state.subarray(row * layers, (row + 1) * layers)];
    this.state.value = rowStates[0] ?? null;
    this.tellStates(rowStates.map((index) => this.stateName(index)));
  }

  /** Takes the state of one layer, as a verdict says. */
  leads(layer: number, index: number, state: string): void {
    this.tellStates(
      (this.cast?.layers ?? []).map((_, l) => (l === layer ? state : (this.layerStates.value[l] ?? ""))),
    );
    if (layer === 0) this.state.value = index;
  }

  /** Returns the cast and row of an actor in the frames, or null. */
  place(actor: number | null = this.actor.value): FrameRow | null {
    const casts = this.stage.hello.value?.casts ?? [];
    for (let cast = 0; cast < casts.length; cast++) {
      const row = casts[cast]!.actors.findIndex(({ id }) => id === actor);
      if (row >= 0) return { cast, row };
    }
    return null;
  }

  /** Returns the index of a state of a layer of `actor`, or -1. */
  stateIndex(actor: number, name: string, layer = 0): number {
    const place = this.place(actor);
    const cast = place && this.stage.hello.value!.casts[place.cast]!;
    return cast ? cast.states.findIndex((state, i) => state === name && cast.state_layers[i] === layer) : -1;
  }

  /** Returns the name of one of the watched actor's states, "" if there is none. */
  stateName(index: number | null): string {
    return (index !== null && this.cast?.states[index]) || "";
  }
}
