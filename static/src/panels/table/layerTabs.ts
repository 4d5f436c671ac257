/** Shows a tab for each layer, if there are several; table and graph show the chosen layer. */

import type { Session } from "../../state/session";
import { el, say } from "../../ui/dom";

export function layerTabs(host: HTMLElement, session: Session): void {
  let buttons: HTMLButtonElement[] = [];
  const mark = (): void =>
    buttons.forEach((button, i) => button.setAttribute("aria-selected", String(i === session.layer.value)));
  const states = (): void =>
    buttons.forEach((button, i) => say(button.querySelector("small")!, session.layerStates.value[i] ?? ""));
  session.machine.on((machine) => {
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
      button.addEventListener("click", () => session.layer.set(i));
      return button;
    });
    host.replaceChildren(...buttons);
    mark();
    states();
  });
  session.layer.on(mark);
  session.layerStates.on(states);
}
