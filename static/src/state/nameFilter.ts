/** Filters the states and events of the shown layer by parts of their names; the table and the graph follow it. */

import { effect, signal } from "@preact/signals-core";
import type { LayerInfo, StateInfo } from "../net/protocol";
import type { WatchedMachine } from "./watchedMachine";

/** Returns the names that contain one of the words; all if none does. */
export function filtered(names: readonly string[], words: string): string[] {
  const parts = words.toLowerCase().split(/\s+/).filter(Boolean);
  const hits = names.filter((name) => parts.some((part) => name.toLowerCase().includes(part)));
  return hits.length ? hits : [...names];
}

export class NameFilter {
  readonly text = signal("");

  /** Another machine or layer gives the filter up. */
  constructor(machine: WatchedMachine) {
    let before = "";
    effect(() => {
      const key = JSON.stringify([machine.info.value?.name, machine.layerInfo?.name]);
      if (key !== before) this.text.value = "";
      before = key;
    });
  }

  apply({ states }: LayerInfo, events: readonly string[]): { states: StateInfo[]; events: string[] } {
    const names = states.map(({ name }) => name);
    const hits = new Set(filtered(names, this.text.value));
    return {
      states: states.filter(({ name }) => hits.has(name)),
      events: filtered(events, this.text.value),
    };
  }
}
