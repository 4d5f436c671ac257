/** Who is watched: the stage's casts, the actor chosen among them, its machine, its state, and what was seen of it. */

import { History } from "./history";
import type { CastHello, Hello, MachineInfo, StateHistory } from "./net/protocol";
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
  readonly history = new History();

  get cast(): CastHello | null {
    const place = this.place();
    return (place && this.hello.value?.casts[place.cast]) ?? null;
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
    const base = changes.filter(({ layer }) => layer === 0);
    for (const actor of new Set(base.map((change) => change.actor))) {
      const own = base.filter((change) => change.actor === actor);
      const known = own.map(({ tick, state }) => ({ tick, state: this.stateIndex(actor, state) })).filter(({ state }) => state >= 0);
      if (known.length) this.history.fill(actor, known, head);
    }
  }

  /** The index of a state of `actor`, or -1. */
  stateIndex(actor: number, name: string): number {
    const place = this.place(actor);
    return place ? this.hello.value!.casts[place.cast]!.states.indexOf(name) : -1;
  }

  /** The name of a state of the watched actor. */
  stateName(index: number | null): string {
    return (index !== null && this.cast?.states[index]) || "";
  }
}
