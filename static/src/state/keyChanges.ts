/** Keys that change parameters while they are down. */

import type { KeyBinding } from "../net/protocol";
import type { ParameterValues } from "./parameterValues";

const ANY_STATE = "*";

/** Returns what a key changes, units a second: of the first state that a layer is in, or of `*`. */
export function ratesOf({ change }: KeyBinding, states: readonly string[]): Record<string, number> {
  const state = Object.keys(change).find((name) => name === ANY_STATE || states.includes(name));
  return state === undefined ? {} : change[state]!;
}

/** Returns the parameters that a key changes in any state. */
export function changedBy({ change }: KeyBinding): string[] {
  return [...new Set(Object.values(change).flatMap((rates) => Object.keys(rates)))];
}

/** Returns whether a key changes the parameter in these states, or no key changes it in any. */
export function changedIn(
  keys: Record<string, KeyBinding>,
  parameter: string,
  states: readonly string[],
): boolean {
  const own = Object.values(keys).filter((binding) => changedBy(binding).includes(parameter));
  return !own.length || own.some((binding) => parameter in ratesOf(binding, states));
}

export class KeyChanges {
  private readonly down = new Map<string, KeyBinding>();

  constructor(
    private readonly values: ParameterValues,
    private readonly states: () => readonly string[],
  ) {}

  /** Returns whether the key changes parameters. */
  press(name: string, binding: KeyBinding): boolean {
    if (!Object.keys(binding.change).length) return false;
    this.down.set(name, binding);
    return true;
  }

  release(name: string): void {
    this.down.delete(name);
  }

  releaseAll(): void {
    this.down.clear();
  }

  /** Moves the parameters by `dt` seconds; called once per drawn frame. */
  advance(dt: number): void {
    for (const binding of this.down.values())
      for (const [name, rate] of Object.entries(ratesOf(binding, this.states())))
        this.values.set(name, this.values.get(name) + rate * dt);
  }
}
