/** The table with all that belongs to it: its editor, the desk below, the bar above. */

import type { Editing } from "../../editing";
import type { Session } from "../../session";
import type { Travelling } from "../../travelling";
import { byId } from "../dom";
import { Desk } from "./desk";
import { EditionBar } from "./editionbar";
import { CellEditor } from "./editor";
import { TablePanel } from "./table";

export class TableRoom {
  private readonly table: TablePanel;
  private readonly editor: CellEditor;

  constructor(
    private readonly session: Session,
    editing: Editing,
    travelling: Travelling,
  ) {
    const wishes = {
      edit: (cell: HTMLTableCellElement, typed: string | null) => void this.editor.open(cell, typed),
      goTo: (state: string) => void travelling.go(state),
    };
    this.table = new TablePanel(byId("table"), byId("verdict"), session, wishes);
    const desk = new Desk(byId("desk"), editing, (finding) => this.table.go(finding));
    this.editor = new CellEditor(byId("table"), session, editing, desk, (state, event) => this.table.cell(state, event));
    new EditionBar(byId("edition"), session, editing, () => desk.toggle());
  }

  /** Leads to a cell. */
  go(layer: number, state: string, event: string): void {
    this.table.go({ state, event, layer: this.session.machine.value?.layers[layer]?.name ?? "" });
  }

  /** Puts a text into a cell, to be kept or dropped. */
  propose(layer: number, state: string, event: string, text: string): void {
    this.go(layer, state, event);
    void this.editor.propose(this.table.cell(state, event), text);
  }
}
