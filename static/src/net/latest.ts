/** Sends the newest of many values, at most so many times a second. */

export class Latest<T> {
  private waiting: T | null = null;
  private timer: ReturnType<typeof setTimeout> | null = null;

  constructor(
    private readonly send: (value: T) => void,
    private readonly perSecond: number,
  ) {}

  /** Sends the value now, or as soon as the rate allows it if no newer value has come until then. */
  put(value: T): void {
    if (this.timer !== null) {
      this.waiting = value;
      return;
    }
    this.send(value);
    this.timer = setTimeout(() => this.next(), 1000 / this.perSecond);
  }

  private next(): void {
    this.timer = null;
    const value = this.waiting;
    this.waiting = null;
    if (value !== null) this.put(value);
  }
}
