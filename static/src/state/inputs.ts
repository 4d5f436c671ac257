/** Sends events to the watched actor. What follows an event in the past waits for the fork that it makes. */

import type { EventKind } from "../net/protocol";
import type { Sender } from "./keyBindings";
import type { Line } from "./line";
import type { Playback } from "./playback";
import type { Selection } from "./selection";

/** When an event counts: at a tick of the past, or in the present. */
type When = { tick: number } | { now: true };

const PRESENT: When = { now: true };

interface InputParts {
  line: Line;
  playback: Playback;
  selection: Selection;
}

export class Inputs {
  /** What follows an event in the past until the page watches its fork: there it would make other forks. */
  private waiting: (() => void)[] | null = null;
  private refs = 1;

  constructor(private readonly parts: InputParts) {}

  /** Whether an event has made a fork that is not watched yet: what is sent now waits for the fork. */
  get isForking(): boolean {
    return this.waiting !== null;
  }

  /**
   * Returns what sends the events of a key that goes down now and comes up later. A key that goes down in the present
   * comes up there, even if the page looks at the past by then.
   */
  sender(): Sender {
    const { playback, selection } = this.parts;
    const [isPresent, actor] = [playback.looking.value === null, selection.actor.value];
    return ({ kind, event }) => {
      const tick = isPresent ? null : playback.looking.peek();
      if (actor === null) return;
      if (this.waiting) return void this.waiting.push(() => this.post(kind, actor, event, PRESENT));
      const isSent = this.post(kind, actor, event, tick === null ? PRESENT : { tick });
      if (isSent && tick !== null) this.waiting = [];
    };
  }

  private post(kind: EventKind, actor: number, event: string, when: When): boolean {
    return this.parts.line.send({ type: "event", kind, actor, event, ref: `event ${this.refs++}`, ...when });
  }

  /** Sends what has waited. */
  sendWaiting(): void {
    const waiting = this.waiting ?? [];
    this.waiting = null;
    for (const send of waiting) send();
  }

  /** Drops what has waited. */
  forget(): void {
    this.waiting = null;
  }
}
