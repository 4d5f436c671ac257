/** Rates over the last seconds: messages, bytes, drawn frames, and the time a question takes to be answered. */

const WINDOW_MS = 2000;

export class Meter {
  private times: number[] = [];
  private amounts: number[] = [];
  private start = 0;
  total = 0;

  /** One more at `now` (milliseconds), weighing `amount`. */
  add(now: number, amount = 1): void {
    this.times.push(now);
    this.amounts.push(amount);
    this.total += 1;
    this.trim(now);
  }

  /** How many a second in the window that ends at `now`. */
  perSecond(now: number): number {
    this.trim(now);
    return ((this.times.length - this.start) * 1000) / WINDOW_MS;
  }

  /** Their amounts a second in the window that ends at `now`. */
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

/** Round-trip time: `ask` gives a number to send along, `answer` takes it back. */
export class RoundTrip {
  private asked = new Map<number, number>();
  private next = 1;
  milliseconds: number | null = null;

  ask(now: number): number {
    if (this.asked.size > 8) this.asked.clear();
    this.asked.set(this.next, now);
    return this.next++;
  }

  /** Whether `ref` was one of ours. */
  answer(ref: unknown, now: number): boolean {
    const asked = typeof ref === "number" ? this.asked.get(ref) : undefined;
    if (asked === undefined) return false;
    this.asked.delete(ref as number);
    this.milliseconds = now - asked;
    return true;
  }
}
