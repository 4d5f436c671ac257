/** The form for the selected cell, arrow or state: each field makes one edit. */

import "./cellInspector.css";
import { effect, type Signal, signal } from "@preact/signals-core";
import { html, noChange, type TemplateResult } from "lit-html";
import type { LayerInfo } from "../../net/protocol";
import { EditingFields } from "../../state/editingFields";
import type { Selected } from "../../state/inspection";
import { draw } from "../../ui/draw";
import type { App } from "../../view/app";
import type { Drag } from "./blendPad";
import { cellForm } from "./cellForm";
import { stateForm } from "./stateForm";

export function cellInspectorPanel(host: HTMLElement, app: App): void {
  const { inspection, machine, editing } = app;
  const fields = new EditingFields(editing);
  const drag = signal<Drag | null>(null);
  let before = "";
  effect(() => {
    const now = JSON.stringify(inspection.selected.value);
    if (now !== before) fields.clear();
    before = now;
  });
  draw(host, () => {
    if (inspection.drawer.value !== "cell") return noChange;
    const selected = inspection.selected.value;
    const info = machine.info.value;
    const layer = info?.layers.find(({ name }) => name === selected?.layer);
    if (!selected || !info || !layer) return hint();
    return form(app, fields, drag, layer, selected);
  });
}

const hint = (): TemplateResult =>
  html`<p class="hint">Choose a cell or a state in the table, or an arrow in the graph.</p>`;

function form(
  app: App,
  fields: EditingFields,
  drag: Signal<Drag | null>,
  layer: LayerInfo,
  selected: Selected,
): TemplateResult {
  const { state, event } = selected;
  const isThere = state === "*" || layer.states.some(({ name, outer }) => name === state || outer === state);
  if (!isThere) return hint();
  if (event === null) return stateForm(app, fields, drag, layer, state);
  return cellForm(app, fields, layer, { layer: layer.name, state, event });
}
