/** Measures rates (messages, bytes, drawn frames) over the last seconds, and round-trip times. */

const WINDOW_MS = 2000;

export class Meter {
  private times: number[] = [];
  private amounts: number[] = [];
  private start = 0;
  total = 0;

  /** Counts one event at `now` (milliseconds) with its `amount`. */
  add(now: number, amount = 1): void {
    this.times.push(now);
    this.amounts.push(amount);
    this.total += 1;
    this.trim(now);
  }

  /** Events per second in the window that ends at `now`. */
  perSecond(now: number): number {
    this.trim(now);
    return ((this.times.length - this.start) * 1000) / WINDOW_MS;
  }

  /** Amount per second in the window that ends at `now`. */
  amountPerSecond(now: number): number {
    this.trim(now);
    let sum = 0;
    for (let i = this.start; i < this.amounts.length; i++) sum += this.amounts[i]!;
    return (sum * 1000) / WINDOW_MS;
  }

  private trim(now: number): void {
    while (this.start < this.times.length && this.times[this.start]! <= now - WINDOW_MS) this.start++;
    if (this.start < 512) return;
    this.times.splice(0, this.start);
    this.amounts.splice(0, this.start);
    this.start = 0;
  }
}

/** Measures round-trip time: `ask` returns a number to send, `answer` takes it back. */
export class RoundTrip {
  private sentAt = new Map<number, number>();
  private next = 1;
  milliseconds: number | null = null;

  ask(now: number): number {
    if (this.sentAt.size > 8) this.sentAt.clear();
    this.sentAt.set(this.next, now);
    return this.next++;
  }

  /** Returns whether `ref` is a number that `ask` gave. */
  answer(ref: unknown, now: number): boolean {
    const sentAt = typeof ref === "number" ? this.sentAt.get(ref) : undefined;
    if (sentAt === undefined) return false;
    this.sentAt.delete(ref as number);
    this.milliseconds = now - sentAt;
    return true;
  }
}
