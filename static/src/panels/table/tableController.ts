/** Connects the table with its cell editor, cell inspector and version bar. */

import type { Editing } from "../../state/editing";
import type { Session } from "../../state/session";
import type { Travel } from "../../state/travel";
import { byId } from "../../ui/dom";
import { CellInspector } from "./cellInspector";
import { VersionBar } from "./versionBar";
import { CellEditor } from "./cellEditor";
import { TablePanel } from "./table";

export class TableController {
  private readonly table: TablePanel;
  private readonly editor: CellEditor;

  constructor(
    private readonly session: Session,
    editing: Editing,
    travel: Travel,
  ) {
    const actions = {
      edit: (cell: HTMLTableCellElement, typed: string | null) => this.editor.open(cell, typed),
      goTo: (state: string) => void travel.go(state),
    };
    this.table = new TablePanel(byId("table"), byId("verdict"), session, actions);
    const inspector = new CellInspector(byId("cell-inspector"), editing, (finding) => this.table.go(finding));
    this.editor = new CellEditor(byId("table"), session, editing, inspector, (state, event) =>
      this.table.cell(state, event),
    );
    new VersionBar(byId("version"), session, editing, () => inspector.toggle());
  }

  /** Shows a cell. */
  go(layer: number, state: string, event: string): void {
    this.table.go({ state, event, layer: this.session.machine.value?.layers[layer]?.name ?? "" });
  }

  /** Types a text into a cell; you keep or drop it. */
  propose(layer: number, state: string, event: string, text: string): void {
    this.go(layer, state, event);
    this.editor.propose(this.table.cell(state, event), text);
  }
}
