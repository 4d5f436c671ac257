/** The keys of the viewer: each panel adds its own, and the help lists them. */

import { signal } from "@preact/signals-core";

export interface Shortcut {
  keys: readonly [string, ...string[]];
  /** What the keys do, in the help. */
  words: string;
  act: () => void;
}

export class Shortcuts {
  readonly all = signal<readonly Shortcut[]>([]);

  add(...more: Shortcut[]): void {
    this.all.value = [...this.all.value, ...more];
  }

  /** Returns the shortcut of a key, in any case. */
  of(key: string): Shortcut | undefined {
    return this.all.value.find(({ keys }) => keys.includes(key.toLowerCase()));
  }
}
