/**
 * Shows one panel at a time on a narrow page; on a wide page all panels are visible and the tabs are hidden.
 */

import { el } from "./dom";

/** Fills `host` with a tab for each section of `panels` that has a `data-tab`. */
export function tabs(host: HTMLElement, panels: HTMLElement): void {
  const sections = [...panels.querySelectorAll<HTMLElement>("[data-tab]")];
  const buttons = sections.map((section) =>
    el("button", { type: "button", role: "tab", "aria-controls": section.id }, section.dataset["tab"] ?? ""),
  );
  const show = (chosen: number): void => {
    sections.forEach((section, i) => section.classList.toggle("chosen", i === chosen));
    buttons.forEach((button, i) => button.setAttribute("aria-selected", String(i === chosen)));
  };
  buttons.forEach((button, i) => button.addEventListener("click", () => show(i)));
  host.append(...buttons);
  show(0);
}
