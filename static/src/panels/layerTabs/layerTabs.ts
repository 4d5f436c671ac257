/** Shows a tab for each layer, if there are several; table and graph show the chosen layer. */

import "./layerTabs.css";
import { html } from "lit-html";
import { draw } from "../../ui/draw";
import type { App } from "../../view/app";

export function layerTabsPanel(host: HTMLElement, { machine, selection }: App): void {
  draw(host, () => {
    const layers = machine.info.value?.layers ?? [];
    host.hidden = layers.length < 2;
    return html`${layers.map(({ name, mask, mode }, i) => {
      const facts = i ? `${mode}, for ${mask.join(", ") || "all joints"}` : "moves the whole body";
      return html`<button
        type="button"
        role="tab"
        title=${`${name}: ${facts}`}
        aria-selected=${i === selection.layer.value}
        @click=${() => (selection.layer.value = i)}
      >
        ${name}<small .textContent=${selection.layerStates.value[i] ?? ""}></small>
      </button>`;
    })}`;
  });
}
