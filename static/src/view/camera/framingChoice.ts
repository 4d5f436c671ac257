/** How much the camera shows: what the watched actor's state asks for when it begins, else what the user chose. */

import { effect, signal } from "@preact/signals-core";
import type { MachineInfo, StateInfo } from "../../net/protocol";
import { Event } from "../../state/event";
import type { State } from "../../state/state";

export type Framing = NonNullable<StateInfo["framing"]>;

/** Returns the framing that the states of an actor, one of each layer, ask for: the highest layer counts. */
function askedBy({ layers }: MachineInfo, states: readonly string[]): Framing | null {
  const asked = layers.map(
    (layer, l) => layer.states.find(({ name }) => name === states[l])?.framing ?? null,
  );
  return asked.filter((framing) => framing !== null).at(-1) ?? null;
}

export class FramingChoice {
  readonly shown = signal<Framing>("whole");
  /** The camera turns to the actor in the shown framing: the user has chosen it. */
  readonly chosen = new Event<void>();
  /** A state began that asks for another framing than the state before; from then on the camera is the user's. */
  readonly staged = new Event<void>();
  private byHand: Framing = "whole";
  /** Undefined: the actor's states are not known yet. */
  private asked: Framing | null | undefined = undefined;

  constructor({ machine, selection, viewpoint }: State) {
    effect(() => {
      const [info, states] = [machine.info.value, selection.layerStates.value];
      if (!info || !machine.isActors || !states.some(Boolean)) return;
      const before = this.asked;
      this.asked = askedBy(info, states);
      if (before === this.asked || (before === undefined && this.asked === null)) return;
      this.shown.value = this.asked ?? this.byHand;
      if (before === undefined && viewpoint.isChosen) return; // the address says where the camera stands
      viewpoint.take();
      this.staged.emit(undefined);
    });
  }

  /** Takes the user's choice, until a state begins that asks for another framing. */
  choose(framing: Framing): void {
    this.byHand = this.shown.value = framing;
    this.chosen.emit(undefined);
  }
}
