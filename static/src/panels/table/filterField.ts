/** The field that filters a large table, and the graph with it. */

import { effect } from "@preact/signals-core";
import type { LayerInfo } from "../../net/protocol";
import type { App } from "../../view/app";
import { el } from "../../ui/dom";

/** A table with fewer states and fewer events is seen as a whole. */
const [MANY_STATES, MANY_EVENTS] = [24, 16];

/** Puts the field above `table`. */
export function filterField(table: HTMLElement, { machine, nameFilter }: App): void {
  const field = el("input", {
    type: "search",
    class: "table-filter",
    placeholder: "filter states and events",
    "aria-label": "filter states and events",
    spellcheck: "false",
  });
  table.before(field);
  field.addEventListener("input", () => (nameFilter.text.value = field.value));
  field.addEventListener("keydown", (press) => {
    press.stopPropagation();
    if (press.key === "Escape") nameFilter.text.value = "";
  });
  nameFilter.text.subscribe((text) => (field.value = text));
  effect(() => {
    const [info, layer] = [machine.info.value, machine.layerInfo];
    field.hidden = !info || !layer || !isLarge(layer, info.events);
  });
}

const isLarge = ({ states }: LayerInfo, events: readonly string[]): boolean =>
  states.length > MANY_STATES || events.length > MANY_EVENTS;
