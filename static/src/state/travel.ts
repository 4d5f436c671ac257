/** Sends the watched actor to a state and holds the plan until it arrives or you cancel. */

import { signal } from "@preact/signals-core";
import * as actors from "../net/actors";
import type { Plan } from "../net/protocol";
import type { Playback } from "./playback";
import type { Selection } from "./selection";
import type { Session } from "./session";

/** Returns the present step of `plan`: the first step from `from` on whose state is `state`, else `from`. */
export function stepAt({ steps }: Plan, state: string, from: number): number {
  const found = steps.findIndex((step, i) => i >= from && step.state === state);
  return found < 0 ? from : found;
}

export class Travel {
  readonly plan = signal<Plan | null>(null);
  private actor = 0;

  constructor(
    private readonly session: Session,
    private readonly selection: Selection,
    private readonly playback: Playback,
  ) {
    selection.state.subscribe((state) => this.arrived(selection.stateName(state)));
    selection.actor.subscribe(() => this.forget());
    session.leaving.on(() => this.forget());
  }

  private forget(): void {
    this.plan.value = null;
  }

  /** Goes live and sends the watched actor to `state`. */
  async go(state: string): Promise<void> {
    const actor = this.selection.actor.value;
    if (actor === null) return;
    this.playback.live();
    await this.session.command(async (stage) => {
      const plan = await actors.travel(stage, actor, state);
      this.actor = actor;
      if (actor === this.selection.actor.value) this.plan.value = plan.steps.length ? plan : null;
      this.arrived(this.selection.stateName(this.selection.state.value)); // it may be there before the answer is
    });
  }

  async cancel(): Promise<void> {
    if (!this.plan.value) return;
    this.forget();
    await this.session.command((stage) => actors.cancelTravel(stage, this.actor));
  }

  private arrived(state: string): void {
    if (this.playback.isLive && state === this.plan.value?.goal) this.forget();
  }
}
