/** The watched stage as the server tells it: its hello, its status, its ticks. */

import { signal } from "@preact/signals-core";
import type { Hello, Status } from "../net/protocol";

export type StageStatus = Pick<Status, "paused" | "speed" | "viewers" | "pace" | "trouble">;

const RATE = 60;

export class WatchedStage {
  id = "";
  readonly hello = signal<Hello | null>(null);
  readonly status = signal<StageStatus>({ paused: false, speed: 1, viewers: 1, pace: 1, trouble: "" });
  /** The shown tick. */
  tick = 0;
  head = 0;
  first = 0;
  hash = "";

  /** Ticks per second. */
  get rate(): number {
    return this.hello.value?.rate ?? RATE;
  }

  /** Returns the lowest id of an actor: the first actor of a scene has it. Null on a stage without actors. */
  get firstActor(): number | null {
    const ids = (this.hello.value?.casts ?? []).flatMap(({ actors }) => actors.map(({ id }) => id));
    return ids.length > 0 ? Math.min(...ids) : null;
  }

  greet(hello: Hello): void {
    this.id = hello.stage;
    Object.assign(this, { tick: hello.tick, head: hello.head, first: hello.first });
    this.learn(hello);
    this.hello.value = hello;
  }

  report(status: Status): void {
    Object.assign(this, { head: Math.max(status.head, this.head), first: status.first });
    this.learn(status);
  }

  private learn({ paused, speed, viewers, pace, trouble }: StageStatus): void {
    const now = { paused, speed, viewers, pace, trouble };
    if (JSON.stringify(this.status.value) !== JSON.stringify(now)) this.status.value = now;
  }

  /** Takes the ticks of a frame. */
  moved(tick: number, head: number): void {
    this.tick = tick;
    this.head = Math.max(this.head, head);
  }
}
