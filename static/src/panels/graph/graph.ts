/** The graph panel: the picture of the state graph, its keys and pointers, and buttons that zoom. */

import "./graph.css";
import { effect } from "@preact/signals-core";
import { el, say } from "../../ui/dom";
import type { App } from "../../view/app";
import { GRAPH_KEYS, GraphKeys } from "./graphKeys";
import { GraphPointer } from "./graphPointer";
import { GraphView } from "./graphView";
import { deleteArrow } from "./graphEdits";

const ZOOM = 1.25;

export function graphPanel(host: HTMLElement, app: App): void {
  const note = el("p", { class: "graph-note", role: "status" });
  const graph = new GraphView(host, app, (words) => say(note, words));
  graph.picture.canvas.setAttribute("aria-description", GRAPH_KEYS);
  const pointer = new GraphPointer(graph, app);
  new GraphKeys(
    graph,
    app,
    (words) => say(note, words),
    () => pointer.cancel(),
  );
  const buttons = [
    button("−", "zoom out", () => graph.camera.zoomBy(1 / ZOOM)),
    button("+", "zoom in", () => graph.camera.zoomBy(ZOOM)),
    button("fit", "fit the graph", () => graph.fit()),
    button("arrange", "arrange: lay the graph out anew", () => void graph.arrange()),
    button("delete", "delete the selected arrow", () => void deleteSelected(app)),
    button("fold", "fold all sub-machines", () => app.folds.toggleAll()),
  ];
  host.append(el("div", { class: "graph-buttons group" }, ...buttons), note);
  app.inspection.selected.subscribe((selected) => (buttons[4]!.hidden = selected?.event == null));
  effect(() => showFolding(buttons[5]!, app.folds));
  app.commands.add(
    { keys: [], words: "graph: zoom in", act: () => graph.camera.zoomBy(ZOOM) },
    { keys: [], words: "graph: zoom out", act: () => graph.camera.zoomBy(1 / ZOOM) },
    { keys: [], words: "graph: fit", act: () => graph.fit() },
    { keys: [], words: "lay the graph out anew", act: () => void graph.arrange() },
    { keys: [], words: "fold or unfold all sub-machines", act: () => app.folds.toggleAll() },
  );
}

function button(words: string, title: string, act: () => void): HTMLButtonElement {
  const made = el("button", { type: "button", "aria-label": title, title }, words);
  made.addEventListener("click", act);
  return made;
}

function showFolding(shown: HTMLButtonElement, { all, names }: App["folds"]): void {
  const isFolded = names.value.size > 0;
  shown.hidden = all.value.length === 0;
  shown.textContent = isFolded ? "unfold" : "fold";
  shown.title = isFolded ? "unfold all sub-machines" : "fold all sub-machines";
  shown.setAttribute("aria-label", shown.title);
}

async function deleteSelected(app: App): Promise<void> {
  const selected = app.inspection.selected.value;
  if (selected && (await deleteArrow(app, selected))) app.inspection.selected.value = null;
}
