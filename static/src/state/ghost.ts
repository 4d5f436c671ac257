/** Another stage, shown over the watched one at the same tick: its own line, its hello and its newest frame. */

import { signal } from "@preact/signals-core";
import type { Hello, ServerMessage } from "../net/protocol";
import { type PoseFrame, readPoseFrame } from "../net/wire";
import type { Event } from "./event";
import { Line } from "./line";
import type { Notice } from "./notice";
import { Scrubber } from "./scrubber";
import type { WatchedStage } from "./watchedStage";

export class Ghost {
  /** The id of the ghost's stage; null: there is no ghost. */
  readonly stage = signal<string | null>(null);
  /** What its stage plays, once it has answered. */
  readonly hello = signal<Hello | null>(null);
  /** The newest frame, until it is drawn. */
  pose: PoseFrame | null = null;
  private readonly scrubber: Scrubber;
  private first = 0;
  private head = 0;

  constructor(
    private readonly watched: WatchedStage,
    private readonly notices: Event<Notice>,
    private readonly line = new Line(),
  ) {
    this.scrubber = new Scrubber(line.send);
    line.messages.on((message) => this.hear(message));
    line.frames.on(({ frame }) => this.take(readPoseFrame(frame)));
    line.failed.on(() => this.lose());
    watched.hello.subscribe((hello) => {
      if (hello && hello.stage === this.stage.value) this.hide();
    });
  }

  show(stage: string): void {
    this.hide();
    this.stage.value = stage;
    this.line.connect(
      stage,
      () => "pose",
      () => null,
    );
  }

  hide(): void {
    this.line.close();
    this.stage.value = this.hello.value = this.pose = null;
  }

  /** The tick that the page shows, or the nearest one that the ghost's stage has. */
  get wanted(): number {
    return Math.min(this.head, Math.max(this.first, this.watched.tick));
  }

  /** Asks for the wanted tick. */
  follow(): void {
    if (this.hello.value === null) return;
    const tick = this.wanted;
    if (tick !== this.scrubber.looking.value) this.scrubber.look(tick);
  }

  private hear(message: ServerMessage): void {
    if (message.type === "hello") this.greet(message);
    else if (message.type === "status") Object.assign(this, { first: message.first, head: message.head });
    else if (message.type === "error") this.scrubber.refused();
  }

  private greet(hello: Hello): void {
    Object.assign(this, { first: hello.first, head: hello.head, pose: null });
    this.scrubber.forget();
    this.hello.value = hello;
  }

  private take(frame: PoseFrame): void {
    if (frame.epoch !== this.hello.value?.epoch) return;
    this.head = Math.max(this.head, frame.head);
    this.pose = frame;
    this.scrubber.arrived(frame.tick);
  }

  private lose(): void {
    this.notices.emit("The ghost has gone: its stage does not answer.");
    this.hide();
  }
}
