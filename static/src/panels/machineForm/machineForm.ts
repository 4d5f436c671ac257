/** The form of the machine: parameters, senses, keys, layers, properties, defaults; each field makes one edit. */

import "./machineForm.css";
import { effect } from "@preact/signals-core";
import { html, noChange } from "lit-html";
import { EditingFields } from "../../state/editingFields";
import { draw } from "../../ui/draw";
import { keepFocus } from "../../ui/keepFocus";
import type { App } from "../../view/app";
import { defaultCells } from "./defaultCells";
import { sectionForm } from "./entries";
import { keySection } from "./keys";
import { layerSection } from "./layers";
import { parameterSection } from "./parameters";
import { propertyForm } from "./properties";
import { addSectionCommands } from "./sectionCommands";
import { senseSection } from "./senses";
import { aboutSection, defaultsSection } from "./settings";

const SECTIONS = [parameterSection, senseSection, keySection, layerSection, defaultsSection, aboutSection];

export function machineFormPanel(host: HTMLElement, app: App): void {
  const { machine, editing, inspection } = app;
  const fields = new EditingFields(editing);
  let shown: string | undefined;
  effect(() => {
    const name = machine.info.value?.name;
    if (name !== shown) fields.clear();
    shown = name;
  });
  draw(host, () => {
    // A large machine has thousands of cells: what is not seen is not drawn.
    if (inspection.drawer.value !== "machine") return noChange;
    const info = machine.info.value;
    if (!info) return html``;
    return html`<h2 .textContent=${info.title || info.name}></h2>
      ${SECTIONS.map((section) => sectionForm(fields, section(info)))} ${defaultCells(app)}
      ${propertyForm(app, fields, info)}`;
  });
  addSectionCommands(host, app);
  const again = keepFocus(host);
  machine.info.subscribe(() => queueMicrotask(again));
}
