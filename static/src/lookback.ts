/** Which tick this page looks at: the stage's newest, or one of the past. One question is under way at a time; the newest wish wins. */

import type { ClientMessage } from "./net/protocol";
import { Signal } from "./store";

export class Lookback {
  /** The tick that is wanted, or null while the page follows the stage. */
  readonly looking = new Signal<number | null>(null);
  private asked: number | null = null;

  constructor(private readonly send: (message: ClientMessage) => boolean) {}

  look(tick: number): void {
    this.looking.set(tick);
    if (this.asked === null) this.ask(tick);
  }

  live(): void {
    this.forget();
    this.send({ type: "live" });
  }

  /** The line or the stage is another one: no answer will come. */
  forget(): void {
    this.asked = null;
    this.looking.set(null);
  }

  /** After a reconnection: asks again. */
  again(): void {
    this.asked = null;
    if (this.looking.value !== null) this.ask(this.looking.value);
  }

  /** A frame of `tick` came; if another one is wanted by now, it is asked for. */
  arrived(tick: number): void {
    if (tick !== this.asked) return;
    this.asked = null;
    const wanted = this.looking.value;
    if (wanted !== null && wanted !== tick) this.ask(wanted);
  }

  /** The server refused something, perhaps the tick: the next wish is asked for afresh. */
  refused(): void {
    this.asked = null;
  }

  private ask(tick: number): void {
    this.asked = this.send({ type: "look", tick }) ? tick : null;
  }
}
