/** Shows a tab for each layer, if there are several; table and graph show the chosen layer. */

import "./layerTabs.css";
import type { App } from "../../view/app";
import { el, say } from "../../ui/dom";

export function layerTabsPanel(host: HTMLElement, app: App): void {
  let buttons: HTMLButtonElement[] = [];
  const mark = (): void =>
    buttons.forEach((button, i) =>
      button.setAttribute("aria-selected", String(i === app.selection.layer.value)),
    );
  const states = (): void =>
    buttons.forEach((button, i) =>
      say(button.querySelector("small")!, app.selection.layerStates.value[i] ?? ""),
    );
  app.machine.info.subscribe((machine) => {
    const layers = machine?.layers ?? [];
    host.hidden = layers.length < 2;
    buttons = layers.map(({ name, mask, mode }, i) => {
      const facts = i ? `${mode}, for ${mask.join(", ") || "all joints"}` : "moves the whole body";
      const button = el(
        "button",
        { type: "button", role: "tab", title: `${name}: ${facts}` },
        name,
        el("small"),
      );
      button.addEventListener("click", () => (app.selection.layer.value = i));
      return button;
    });
    host.replaceChildren(...buttons);
    mark();
    states();
  });
  app.selection.layer.subscribe(mark);
  app.selection.layerStates.subscribe(states);
}
