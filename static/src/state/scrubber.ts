/** Holds the past tick that this page shows. One request is sent at a time; the newest wanted tick wins. */

import { signal } from "@preact/signals-core";
import type { ClientMessage } from "../net/protocol";

export class Scrubber {
  /** The wanted tick, or null while the page follows the stage. */
  readonly looking = signal<number | null>(null);
  private requested: number | null = null;

  constructor(private readonly send: (message: ClientMessage) => boolean) {}

  look(tick: number): void {
    this.looking.value = tick;
    if (this.requested === null) this.request(tick);
  }

  live(): void {
    this.forget();
    this.send({ type: "live" });
  }

  /** Follows the stage again, without waiting for an answer. */
  forget(): void {
    this.requested = null;
    this.looking.value = null;
  }

  /** Sends the request again after a reconnection. */
  again(): void {
    this.requested = null;
    if (this.looking.value !== null) this.request(this.looking.value);
  }

  /** Notes that the frame of `tick` came, and requests another tick if one is wanted by now. */
  arrived(tick: number): void {
    if (tick !== this.requested) return;
    this.requested = null;
    const wanted = this.looking.value;
    if (wanted !== null && wanted !== tick) this.request(wanted);
  }

  /** Stops waiting: the server refused a request, which may have been this one. */
  refused(): void {
    this.requested = null;
  }

  private request(tick: number): void {
    this.requested = this.send({ type: "look", tick }) ? tick : null;
  }
}
