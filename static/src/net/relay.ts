/** Between the socket and the page: acknowledges every frame at once, and hands on no more than the page can take; the newest wins. */

import { chunksOf, tickOf } from "./glb";
import { isGlb, tickOfPose } from "./wire";

/** So many frames may lie before the page unread: they are few, so that none is old. */
const MOST_WAITING = 4;

export interface Handed {
  frame: ArrayBuffer;
  /** Frames and bytes that came and were passed over for this one. */
  skipped: number;
  skippedBytes: number;
}

/** The tick of a binary message, or null if it is none of ours. */
export function tickOfMessage(buffer: ArrayBuffer): number | null {
  try {
    return isGlb(buffer) ? tickOf(chunksOf(buffer)) : tickOfPose(buffer);
  } catch {
    return null;
  }
}

export class Relay {
  private waiting = 0;
  private newest: ArrayBuffer | null = null;
  private skipped = 0;
  private skippedBytes = 0;

  constructor(
    private readonly ack: (tick: number) => void,
    private readonly hand: (handed: Handed) => void,
  ) {}

  receive(buffer: ArrayBuffer): void {
    const tick = tickOfMessage(buffer);
    if (tick !== null) this.ack(tick);
    if (this.newest) {
      this.skipped++;
      this.skippedBytes += this.newest.byteLength;
    }
    this.newest = buffer;
    this.pass();
  }

  /** The page took a frame. */
  taken(): void {
    this.waiting--;
    this.pass();
  }

  private pass(): void {
    if (!this.newest || this.waiting >= MOST_WAITING) return;
    const handed = { frame: this.newest, skipped: this.skipped, skippedBytes: this.skippedBytes };
    this.waiting++;
    this.newest = null;
    this.skipped = this.skippedBytes = 0;
    this.hand(handed);
  }
}
