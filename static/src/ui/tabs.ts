/**
 * Shows one panel at a time on a narrow page; on a wide page all panels are visible and the tabs are hidden.
 */

import { el } from "./dom";

/**
 * Fills `host` with a tab for each name in `data-tab` of the sections of `panels`; sections of one name are shown
 * together. A tab whose sections are all hidden is hidden, too.
 */
export function tabs(host: HTMLElement, panels: HTMLElement): void {
  const sections = [...panels.querySelectorAll<HTMLElement>("[data-tab]")];
  const names = [...new Set(sections.map(({ dataset }) => dataset["tab"]!))];
  const of = (name: string): HTMLElement[] => sections.filter(({ dataset }) => dataset["tab"] === name);
  const buttons = names.map((name) =>
    el("button", { type: "button", role: "tab", "aria-controls": of(name)[0]!.id }, name),
  );
  let [chosen] = names;
  const show = (): void => {
    const shown = names.filter((name) => of(name).some(({ hidden }) => !hidden));
    const seen = shown.find((name) => name === chosen) ?? shown[0];
    for (const section of sections) section.classList.toggle("chosen", section.dataset["tab"] === seen);
    names.forEach((name, i) => {
      buttons[i]!.hidden = !shown.includes(name);
      buttons[i]!.setAttribute("aria-selected", String(name === seen));
    });
  };
  buttons.forEach((button, i) =>
    button.addEventListener("click", () => {
      chosen = names[i];
      show();
    }),
  );
  const hiding = new MutationObserver(show);
  for (const section of sections) hiding.observe(section, { attributeFilter: ["hidden"] });
  host.append(...buttons);
  show();
}
