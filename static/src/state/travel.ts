/** Sends the watched actor to a state and holds the plan until it arrives or you cancel. */

import * as actors from "../net/actors";
import type { Plan } from "../net/protocol";
import type { Session } from "./session";
import { Signal } from "./signal";

/** Returns the present step of `plan`: the first step from `from` on whose state is `state`, else `from`. */
export function stepAt({ steps }: Plan, state: string, from: number): number {
  const found = steps.findIndex((step, i) => i >= from && step.state === state);
  return found < 0 ? from : found;
}

export class Travel {
  readonly plan = new Signal<Plan | null>(null);
  private actor = 0;

  constructor(private readonly session: Session) {
    session.state.on((state) => this.arrived(session.stateName(state)));
    session.actor.on(() => this.plan.set(null));
    session.leaving.on(() => this.plan.set(null));
  }

  /** Goes live and sends the watched actor to `state`. */
  async go(state: string): Promise<void> {
    const actor = this.session.actor.value;
    if (actor === null) return;
    this.session.live();
    await this.session.command(async (stage) => {
      const plan = await actors.travel(stage, actor, state);
      this.actor = actor;
      if (actor === this.session.actor.value) this.plan.set(plan.steps.length ? plan : null);
      this.arrived(this.session.stateName(this.session.state.value)); // it may be there before the answer is
    });
  }

  async cancel(): Promise<void> {
    if (!this.plan.value) return;
    this.plan.set(null);
    await this.session.command((stage) => actors.cancelTravel(stage, this.actor));
  }

  private arrived(state: string): void {
    if (this.session.looking.value === null && state === this.plan.value?.goal) this.plan.set(null);
  }
}
