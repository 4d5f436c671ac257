/** Filters the rows and columns of a large table by parts of their names. */

import { effect, signal } from "@preact/signals-core";
import type { LayerInfo, StateInfo } from "../../net/protocol";
import type { App } from "../../view/app";
import { el } from "../../ui/dom";

/** A table with fewer states and fewer events is seen as a whole. */
const [MANY_STATES, MANY_EVENTS] = [24, 16];

/** Returns the names that contain one of the words; all if none does. */
export function filtered(names: readonly string[], words: string): string[] {
  const parts = words.toLowerCase().split(/\s+/).filter(Boolean);
  const hits = names.filter((name) => parts.some((part) => name.toLowerCase().includes(part)));
  return hits.length ? hits : [...names];
}

export class Filter {
  readonly text = signal("");
  private readonly field = el("input", {
    type: "search",
    class: "table-filter",
    placeholder: "filter states and events",
    "aria-label": "filter states and events",
    spellcheck: "false",
  });

  /** Puts the field above `table`. */
  constructor(table: HTMLElement, { machine, selection }: App) {
    table.before(this.field);
    this.field.addEventListener("input", () => (this.text.value = this.field.value));
    this.field.addEventListener("keydown", (press) => {
      press.stopPropagation();
      if (press.key === "Escape") this.clear();
    });
    let before = "";
    effect(() => {
      const info = machine.info.value;
      const layer = info?.layers[selection.layer.value];
      const key = JSON.stringify([info?.name, layer?.name]);
      if (key !== before) this.clear();
      before = key;
      this.field.hidden = !info || !layer || !isLarge(layer, info.events);
    });
  }

  apply(layer: LayerInfo, events: readonly string[]): { states: StateInfo[]; events: string[] } {
    const names = new Set(
      filtered(
        layer.states.map(({ name }) => name),
        this.text.value,
      ),
    );
    return {
      states: layer.states.filter(({ name }) => names.has(name)),
      events: filtered(events, this.text.value),
    };
  }

  clear(): void {
    this.field.value = this.text.value = "";
  }
}

const isLarge = ({ states }: LayerInfo, events: readonly string[]): boolean =>
  states.length > MANY_STATES || events.length > MANY_EVENTS;
