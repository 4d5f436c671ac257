/** Acknowledges every frame at once, and gives the page the newest one when it is ready for it. */

import { chunksOf, tickOf } from "./glb";
import { isGlb, tickOfPose } from "./wire";

/** Frames that the page has not taken yet; few, so that none of them is old. */
const MOST_WAITING = 4;

export interface Delivery {
  frame: ArrayBuffer;
  /** Older frames that were left out, and their bytes. */
  skipped: number;
  skippedBytes: number;
}

/** Returns the tick of a binary message, or null if it is no frame. */
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
    private readonly hand: (delivery: Delivery) => void,
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

  /** Notes that the page took a frame. */
  taken(): void {
    this.waiting--;
    this.pass();
  }

  private pass(): void {
    if (!this.newest || this.waiting >= MOST_WAITING) return;
    const delivery = { frame: this.newest, skipped: this.skipped, skippedBytes: this.skippedBytes };
    this.waiting++;
    this.newest = null;
    this.skipped = this.skippedBytes = 0;
    this.hand(delivery);
  }
}
