/** Signals (a value with listeners) and events (listeners without a value). */

export type Listener<T> = (value: T) => void;

export class Signal<T> {
  private listeners = new Set<Listener<T>>();

  constructor(private current: T) {}

  get value(): T {
    return this.current;
  }

  /** Sets the value; calls the listeners if it differs from the old one. */
  set(value: T): void {
    if (Object.is(value, this.current)) return;
    this.current = value;
    for (const listener of this.listeners) listener(value);
  }

  /** Calls `listener` now and at every change; returns a function that removes it. */
  on(listener: Listener<T>): () => void {
    this.listeners.add(listener);
    listener(this.current);
    return () => this.listeners.delete(listener);
  }
}

/** Calls its listeners with each emitted value. */
export class Event<T> {
  private listeners = new Set<Listener<T>>();

  emit(value: T): void {
    for (const listener of this.listeners) listener(value);
  }

  on(listener: Listener<T>): void {
    this.listeners.add(listener);
  }
}
