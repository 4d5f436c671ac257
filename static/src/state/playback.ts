/** The tick that this page shows: the stage's newest, or a past one, replayed on this page only. */

import { type ReadonlySignal, signal } from "@preact/signals-core";
import type { ClientMessage } from "../net/protocol";
import { Scrubber } from "./scrubber";
import type { WatchedStage } from "./watchedStage";

export class Playback {
  readonly scrubber: Scrubber;
  readonly replaying = signal(false);
  /** The ticks that are replayed again and again; null: the replay goes on to the newest. */
  readonly loop = signal<{ from: number; to: number } | null>(null);
  private at = 0;

  constructor(
    private readonly stage: WatchedStage,
    send: (message: ClientMessage) => boolean,
  ) {
    this.scrubber = new Scrubber(send);
    this.looking.subscribe((tick) => {
      if (tick === null) this.replaying.value = false;
      if (tick === null) this.loop.value = null;
    });
  }

  /** The past tick that this page shows, or null while it follows the stage. */
  get looking(): ReadonlySignal<number | null> {
    return this.scrubber.looking;
  }

  get isLive(): boolean {
    return this.looking.value === null;
  }

  /** Shows `tick` on this page only. */
  look(tick: number): void {
    const { first, head } = this.stage;
    this.scrubber.look(Math.round(Math.min(head, Math.max(first, tick))));
  }

  live(): void {
    this.scrubber.live();
  }

  /** Plays or pauses the replay of the past. */
  toggle(): void {
    if (this.looking.value === null) return;
    this.at = this.looking.value;
    this.replaying.value = !this.replaying.value;
  }

  /** Replays a span again and again, from its begin; null: the replay goes on. */
  repeat(span: { from: number; to: number } | null): void {
    this.loop.value = span;
    if (!span) return;
    this.look(span.from);
    this.at = span.from;
    this.replaying.value = true;
  }

  /** Moves the replay on by `dt` seconds; at the head the page goes live. */
  advance(dt: number): void {
    if (!this.replaying.value) return;
    this.at += dt * this.stage.rate * this.stage.status.value.speed;
    const loop = this.loop.value;
    if (loop && (this.at > loop.to || this.at < loop.from)) this.at = loop.from;
    if (!loop && this.at >= this.stage.head) this.live();
    else this.look(this.at);
  }

  /** Steps by `ticks`, which may be negative. Returns false if that leads past the head. */
  step(ticks: number): boolean {
    const from = this.looking.value ?? this.stage.tick;
    this.replaying.value = false;
    if (from + ticks > this.stage.head) return false;
    this.look(from + ticks);
    return true;
  }
}
