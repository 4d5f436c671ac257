/**
 * Shows the state table of a layer; marks the live row and the last cell that fired; moves the keyboard's
 * focus.
 */

import "./cells.css";
import "./table.css";
import type { Finding, LayerInfo, Verdict } from "../../net/protocol";
import type { App } from "../../view/app";
import { el, flash, say } from "../../ui/dom";
import { columns, drawHead, keepWidths, linesOf } from "./drawTable";
import { headMenu } from "./headMenu";
import { moved } from "./gridMoves";
import { reveal, revealSideways } from "./reveal";
import { TableBody } from "./tableBody";
import { filterField } from "./filterField";
import { verdictLine } from "./verdictLine";

/** Opens the editor of a cell, with its text or with a typed letter. */
type Edit = (cell: HTMLTableCellElement, typed: string | null) => void;

/** A table with more rows keeps the widths of its columns. */
const MANY_ROWS = 60;

export class Table {
  private readonly table = el("table", { "aria-label": "state table", role: "grid" });
  private readonly body: TableBody;
  private head = el("tr");
  private shown: string[] = [];
  /** The names of the rows and columns that are drawn. */
  private names = "";
  private readonly menu: ReturnType<typeof headMenu>;

  constructor(
    private readonly host: HTMLElement,
    private readonly line: HTMLElement,
    private readonly app: App,
    private readonly edit: Edit,
  ) {
    this.body = new TableBody(host);
    filterField(host, app);
    this.table.append(el("thead", {}, this.head), this.body.element);
    host.append(this.table);
    app.nameFilter.text.subscribe(() => this.draw());
    app.machine.info.subscribe(() => this.draw());
    app.selection.layer.subscribe(() => this.draw());
    app.folds.names.subscribe(() => this.draw());
    app.selection.layerStates.subscribe(() => this.mark());
    app.session.verdicts.on((verdict) => this.judge(verdict));
    // After the table: its menu looks for the drawn head.
    this.menu = headMenu(host, app);
    this.table.addEventListener("focusin", (focus) => this.select(focus.target));
    this.table.addEventListener("click", (click) => this.clicked(click));
    this.table.addEventListener("contextmenu", (click) => this.askedForMenu(click));
    this.table.addEventListener("keydown", (press) => this.pressed(press));
  }

  private draw(): void {
    const [layer, machine] = [this.app.machine.layerInfo, this.app.machine.info.value];
    if (!layer || !machine) return;
    const focused = this.table.contains(document.activeElement)
      ? (document.activeElement as HTMLElement).dataset
      : null;
    const goTo = layer === machine.layers[0] ? (state: string) => void this.app.travel.go(state) : null;
    const { states, events } = this.app.nameFilter.apply(layer, columns(layer, machine.events));
    const names = JSON.stringify([machine.name, layer.name, states.map(({ name }) => name), events]);
    if (names !== this.names) this.drawHead(layer, states.length, events);
    this.names = names;
    const { shown } = this.app.folds;
    const fold = (name: string, isFolded: boolean): void => this.fold(name, isFolded);
    this.body.fill(
      linesOf(layer, states, events, { shown: shown.value, fold, goTo }).map((line) => ({
        ...line,
        draw: () => {
          const row = line.draw();
          row.toggleAttribute("aria-current", line.name !== "" && line.name === this.live);
          return row;
        },
      })),
    );
    const [first] = this.body.rows();
    if (!this.table.querySelector("td[tabindex='0']")) first?.[1].cells[1]?.setAttribute("tabindex", "0");
    this.line.textContent = "";
    if (focused?.["state"]) this.focus(this.cell(focused["state"], focused["column"] ?? ""));
    this.mark();
  }

  cell(state: string, event: string): HTMLTableCellElement | null {
    const column = this.shown.indexOf(event);
    return column < 0 ? null : (this.body.row(state)?.cells[column + 1] ?? null);
  }

  private drawHead(layer: LayerInfo, states: number, events: string[]): void {
    this.shown = events;
    this.head = drawHead(events);
    if (states > MANY_ROWS) keepWidths(this.head, layer, events);
    this.table.setAttribute("aria-rowcount", String(states + 1));
    this.table.tHead!.replaceChildren(this.head);
  }

  /** What stands for the live state. */
  private get live(): string {
    const { shownState } = this.app.selection;
    return this.app.folds.shown.value.get(shownState) ?? shownState;
  }

  /** Folds a sub-machine or unfolds it; the keyboard's focus stays on its name. */
  private fold(name: string, isFolded: boolean): void {
    this.app.folds.fold([name], isFolded);
    this.table
      .querySelector<HTMLElement>(`[data-fold="${CSS.escape(name)}"]`)
      ?.focus({ preventScroll: true });
  }

  /** Shows the cell of a finding, or its row. */
  go({ state, event, layer }: Pick<Finding, "state" | "event" | "layer">): void {
    const index =
      this.app.machine.info.value?.layers.findIndex(({ name }) => name === (layer || "base")) ?? -1;
    if (index >= 0) this.app.selection.layer.value = index;
    if (state) this.unfilter(state, event);
    const row = state ? this.body.row(state) : null;
    if (!row || !state) return;
    reveal(this.host, row);
    const cell = event ? this.cell(state, event) : null;
    if (cell) this.sideways(cell);
    flash(cell ?? row, "shown");
    this.focus(cell);
  }

  /** Unfolds what hides the state, and gives the filter up if that hides what shall be shown. */
  private unfilter(state: string, event: string | null): void {
    this.app.folds.reveal(state);
    const isShown = this.body.states.includes(state) && (event === null || this.shown.includes(event));
    if (!isShown) this.app.nameFilter.text.value = "";
  }

  private focus(cell: HTMLElement | null): void {
    if (!cell) return;
    this.table.querySelectorAll("[tabindex='0']").forEach((old) => old.setAttribute("tabindex", "-1"));
    cell.setAttribute("tabindex", "0");
    cell.focus({ preventScroll: true });
  }

  /** Tells the other panels which cell or state is meant. */
  private select(target: EventTarget | null): void {
    const layer = this.app.machine.layerInfo;
    const { state, column } = target instanceof HTMLTableCellElement ? target.dataset : {};
    if (layer && state)
      this.app.inspection.selected.value = { layer: layer.name, state, event: column ?? null };
  }

  private clicked({ target }: Event): void {
    const cell = target instanceof Element ? target.closest("td") : null;
    this.select(cell);
    const head = target instanceof Element && !target.closest(".go") ? target.closest("th") : null;
    if (head?.hasAttribute("tabindex")) this.openMenu(head);
    if (cell) this.edit(cell, null);
  }

  private askedForMenu(click: Event): void {
    const head = click.target instanceof Element ? click.target.closest<HTMLElement>("th[tabindex]") : null;
    if (!head) return;
    click.preventDefault();
    this.openMenu(head);
  }

  private openMenu(head: HTMLElement): void {
    const { state, column } = head.dataset;
    const kind = state ? "state" : column ? "event" : "corner";
    this.menu({ kind, name: state ?? column ?? "" }, head);
  }

  /** Handles the keys of the focused cell or head; the keys that it has no use for reach the character. */
  private pressed(press: KeyboardEvent): void {
    const cell = press.target;
    if (press.altKey && press.key === "Enter") {
      this.app.inspection.drawer.value = "cell";
      press.preventDefault();
      return;
    }
    if (
      !(cell instanceof HTMLTableCellElement) ||
      press.ctrlKey ||
      press.metaKey ||
      press.altKey ||
      press.key === "Tab"
    )
      return;
    if (press.key === "Escape") cell.blur();
    else if (this.move(cell, press.key) || this.act(cell, press.key)) press.preventDefault();
    else return;
    press.stopPropagation();
  }

  private move(cell: HTMLTableCellElement, key: string): boolean {
    const states = this.body.states;
    const row = cell.parentElement as HTMLTableRowElement;
    const at = { row: states.indexOf(cell.dataset["state"] ?? "") + 1, column: cell.cellIndex };
    const spot = moved(at, key, states.length + 1, row.cells.length);
    const to = spot && (spot.row ? this.body.row(states[spot.row - 1]!) : this.head);
    const next = to?.cells[spot!.column];
    if (!next) return false;
    reveal(this.host, next.parentElement!);
    this.sideways(next);
    this.focus(next.hasAttribute("tabindex") ? next : null);
    return true;
  }

  private act(cell: HTMLTableCellElement, key: string): boolean {
    const starts = key === "Enter" || key === "F2";
    if (cell.tagName === "TH") {
      if (starts) this.openMenu(cell);
      return starts;
    }
    if (starts) this.edit(cell, null);
    else if (key === "Delete" || key === "Backspace") this.edit(cell, "");
    else if (key.length === 1 && key !== "?") this.edit(cell, key);
    else return false;
    return true;
  }

  private mark(): void {
    const { live } = this;
    // While you work in the table it does not scroll by itself.
    const row = this.host.contains(document.activeElement) ? null : this.body.row(live);
    for (const [name, drawn] of this.body.rows()) drawn.toggleAttribute("aria-current", name === live);
    if (row) reveal(this.host, row);
  }

  private sideways(cell: HTMLElement): void {
    revealSideways({ host: this.host, table: this.table, heads: [...this.head.cells] }, cell);
  }

  private judge(verdict: Verdict): void {
    if (verdict.event === "END" && verdict.verdict !== "taken") return;
    say(this.line, verdictLine(verdict));
    this.line.dataset["verdict"] = verdict.verdict;
    this.line.dataset["tick"] = String(verdict.tick);
    const cell =
      verdict.layer === this.app.selection.layer.value ? this.cell(verdict.from, verdict.event) : null;
    if (!cell) return;
    if (verdict.verdict === "taken") {
      this.table.querySelector(".last")?.classList.remove("last");
      cell.classList.add("last");
      // A motion that only begins again moves nothing.
      const isLoop = verdict.event === "END" && !verdict.to;
      if (!isLoop && !this.host.contains(document.activeElement)) this.sideways(cell);
    }
    flash(cell, verdict.verdict);
  }
}
