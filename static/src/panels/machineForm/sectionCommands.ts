/** Commands that lead to a section of the machine's form: the palette finds them by what the section is for. */

import type { App } from "../../view/app";

/** By section, what it is for. */
const WORDS: Readonly<Record<string, string>> = {
  parameters: "parameters: numbers, switches and points that conditions and motions read",
  senses: "senses: events that a condition or a touch raises",
  keys: "keys of the machine: which key sends which event",
  layers: "layers: motions over a part of the body",
  defaults: "defaults: moment, blend, curve and wait of cells that name none",
  about: "about the machine: title, description, idle event, fallback, feet that hold",
  "rows and columns": "default rows and columns of the table",
  properties: "properties: what must always be true of the table, and its proof",
};

export function addSectionCommands(host: HTMLElement, { commands, inspection }: App): void {
  for (const [section, words] of Object.entries(WORDS)) {
    const act = (): void => {
      inspection.drawer.value = "machine";
      openSection(host, section);
    };
    commands.add({ keys: [], words, act });
  }
}

/** Opens a section of the form that is drawn, and leads the keyboard there. */
function openSection(host: HTMLElement, section: string): void {
  const details = host.querySelector<HTMLDetailsElement>(`[data-section="${section}"]`);
  if (!details) return;
  details.open = true;
  details.querySelector("summary")!.focus();
  details.scrollIntoView({ block: "start" });
}
