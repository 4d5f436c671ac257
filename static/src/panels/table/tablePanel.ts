/** Connects the table with its cell editor, trial report, version bar and the line of the last verdict. */

import type { CellRequest } from "../../state/inspection";
import type { App } from "../../view/app";
import { byId } from "../../ui/dom";
import { CellEditor } from "./cellEditor";
import { TrialReport } from "./trialReport";
import { Table } from "./table";
import { versionBar } from "./versionBar";

export function tablePanel(_host: HTMLElement, app: App): void {
  const table: Table = new Table(byId("table"), byId("verdict"), app, (cell, typed) =>
    editor.open(cell, typed),
  );
  const inspector = new TrialReport(
    byId("cell-inspector"),
    app.editing,
    (finding) => {
      if (finding.state) table.go(finding);
      else app.inspection.showFileLine(finding.line);
    },
    () => {
      editor.leave();
      app.inspection.drawer.value = "cell";
    },
  );
  const editor: CellEditor = new CellEditor(byId("table"), app, inspector, (state, event) =>
    table.cell(state, event),
  );
  versionBar(byId("version"), app, () => inspector.toggle());
  app.inspection.cells.on(({ layer, state, event, text }: CellRequest) => {
    table.go({ state, event, layer: app.machine.info.value?.layers[layer]?.name ?? "" });
    if (text !== null) editor.propose(table.cell(state, event), text);
  });
  // The shown verdict belongs to the stage that the page leaves.
  app.session.leaving.on(() => {
    const line = byId("verdict");
    line.textContent = "";
    delete line.dataset["verdict"];
    delete line.dataset["tick"];
    byId("table").querySelector(".last")?.classList.remove("last");
  });
  const why = (): void => {
    const { tick } = byId("verdict").dataset;
    if (tick) app.inspection.why.value = Number(tick);
  };
  byId("verdict").addEventListener("click", why);
  const addTo = (): void => byId("table").querySelector<HTMLElement>("th.corner")?.click();
  app.commands.add(
    { keys: ["w"], words: "why: the newest event", act: why },
    { keys: [], words: "table: add a state, an event", act: addTo },
  );
}
