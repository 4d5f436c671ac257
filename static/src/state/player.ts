/** Replays the past on this page only: plays, steps, returns to live. */

import type { Session } from "./session";
import { Signal } from "./signal";

export class Player {
  readonly replaying = new Signal(false);
  private at = 0;

  constructor(private readonly session: Session) {
    session.looking.on((tick) => tick === null && this.replaying.set(false));
  }

  toggle(): void {
    if (this.session.looking.value === null) return;
    this.at = this.session.looking.value;
    this.replaying.set(!this.replaying.value);
  }

  /** Moves the replay on by `dt` seconds; at the head the page goes live. */
  advance(dt: number): void {
    if (!this.replaying.value) return;
    const rate = this.session.hello.value?.rate ?? 60;
    this.at += dt * rate * this.session.status.value.speed;
    if (this.at >= this.session.head) this.session.live();
    else this.session.look(this.at);
  }

  /** Steps by `ticks`, which may be negative. Returns false if that leads past the head. */
  step(ticks: number): boolean {
    const from = this.session.looking.value ?? this.session.tick;
    this.replaying.set(false);
    if (from + ticks > this.session.head) return false;
    this.session.look(from + ticks);
    return true;
  }
}
