/** The latest turns of a joint, frame by frame. */

/** Frames further apart than this are not joined, ticks. */
const MOST_TICKS = 30;
/** Frames that are kept. */
const KEPT = 600;

export type Turns = readonly [number, number, number];

export class JointTrack {
  private followed = "";
  readonly ticks: number[] = [];
  /** About X, Y and Z, degrees. */
  readonly turns: readonly [number[], number[], number[]] = [[], [], []];

  /** Adds the turns at a tick of what `key` names; another key and a jump in time begin a new track. */
  add(key: string, tick: number, turns: Turns): void {
    const last = this.ticks.at(-1) ?? tick;
    if (key !== this.followed || tick < last || tick > last + MOST_TICKS) this.clear();
    this.followed = key;
    if (tick === this.ticks.at(-1)) return;
    this.ticks.push(tick);
    turns.forEach((turn, axis) => this.turns[axis]!.push(turn));
    if (this.ticks.length <= KEPT) return;
    for (const row of [this.ticks, ...this.turns]) row.shift();
  }

  clear(): void {
    for (const row of [this.ticks, ...this.turns]) row.length = 0;
  }
}
