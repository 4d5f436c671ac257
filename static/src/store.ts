/** A value that tells those who listen when it changes. */

export type Listener<T> = (value: T) => void;

export class Signal<T> {
  private listeners = new Set<Listener<T>>();

  constructor(private current: T) {}

  get value(): T {
    return this.current;
  }

  /** Sets the value; listeners hear of it only if it is another one. */
  set(value: T): void {
    if (Object.is(value, this.current)) return;
    this.current = value;
    for (const listener of this.listeners) listener(value);
  }

  /** Calls `listener` now and at every change; gives the way to stop. */
  on(listener: Listener<T>): () => void {
    this.listeners.add(listener);
    listener(this.current);
    return () => this.listeners.delete(listener);
  }
}

/** Something that happens, with those who want to hear of it. */
export class Bell<T> {
  private listeners = new Set<Listener<T>>();

  ring(value: T): void {
    for (const listener of this.listeners) listener(value);
  }

  on(listener: Listener<T>): void {
    this.listeners.add(listener);
  }
}
