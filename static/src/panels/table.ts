/** The state table: states down, events across; the live row, and the cell that fired last. */

import type { Cell, MachineInfo, Verdict } from "../net/protocol";
import type { Session } from "../session";
import { el, flash, say } from "./dom";

/** What stands in a cell: `WALK!` restarts, `TLFT ⇥` waits for the end, `⇥ left-down` for a marker, `–` means nothing; or nothing at all. */
export function cellText(cell: Cell | null | undefined): { to: string; how: string } {
  if (!cell) return { to: "", how: "" };
  if (cell.to === null || cell.to === "-") return { to: "–", how: "" };
  const how = cell.when && cell.when !== "now" ? `⇥ ${cell.when.replace(/^(end|marker )/, "")}`.trim() : "";
  return { to: cell.restart ? `${cell.to}!` : cell.to, how };
}

/** A cell in a sentence, for the tooltip. */
export function cellSentence(state: string, event: string, cell: Cell | null | undefined): string {
  if (!cell) return `${state}, ${event}: nothing yet`;
  if (cell.to === null || cell.to === "-") return `${state}, ${event}: means nothing here`;
  const facts = [
    cell.when && cell.when !== "now" ? `at ${cell.when}` : "at once",
    cell.blend ? `blend ${cell.blend.toFixed(2)} s` : "",
    cell.restart ? "starts the motion again" : "",
    cell.action ? `action ${cell.action}` : "",
    isDefault(cell) ? `from ${cell.source}` : "",
  ];
  return `${state}, ${event} → ${cell.to}: ${facts.filter(Boolean).join(", ")}`;
}

export function isDefault(cell: Cell): boolean {
  return cell.source !== undefined && cell.source !== "cell";
}

function drawCell(state: string, event: string, cell: Cell | null | undefined, known: ReadonlySet<string>): HTMLTableCellElement {
  const { to, how } = cellText(cell);
  const classes = [
    cell && isDefault(cell) ? "default" : "",
    cell?.to === state ? "stay" : "",
    cell?.to && to !== "–" && !known.has(cell.to) ? "undefined" : "",
    to === "–" ? "off" : "",
  ];
  const content = el("span", { class: "to" }, to);
  return el("td", { class: classes.filter(Boolean).join(" "), title: cellSentence(state, event, cell) }, content, how ? el("small", {}, how) : null);
}

/** What became of an event, in one line. */
export function verdictLine({ verdict, event, from, to, reason }: Verdict): string {
  const taken = to ? `${from ?? ""} → ${to}` : `stays in ${from ?? "?"}`;
  const way = verdict === "taken" ? taken : `${verdict} in ${from ?? "?"}`;
  return reason && verdict !== "taken" ? `${event}: ${way}, ${reason}` : `${event}: ${way}`;
}

export class TablePanel {
  private readonly table = el("table", { "aria-label": "state table" });
  private rows = new Map<string, HTMLTableRowElement>();
  private cells = new Map<string, HTMLTableCellElement>();

  constructor(
    private readonly host: HTMLElement,
    private readonly line: HTMLElement,
    private readonly session: Session,
  ) {
    host.append(this.table);
    session.machine.on((machine) => machine && this.draw(machine));
    session.state.on(() => this.mark());
    session.verdicts.on((verdict) => this.judge(verdict));
  }

  private draw(machine: MachineInfo): void {
    const known = new Set(machine.states.map((state) => state.name));
    const head = el("tr", {}, el("th", { scope: "col", class: "corner" }, "state"), ...machine.events.map((event) => el("th", { scope: "col" }, event)));
    this.cells.clear();
    const rows = machine.states.map(({ name }) => {
      const cells = machine.events.map((event) => this.keep(name, event, drawCell(name, event, machine.table[name]?.[event], known)));
      return [name, el("tr", {}, el("th", { scope: "row" }, name), ...cells)] as const;
    });
    this.rows = new Map(rows);
    this.table.replaceChildren(el("thead", {}, head), el("tbody", {}, ...this.rows.values()));
    this.line.textContent = "";
    this.mark();
  }

  private keep(state: string, event: string, cell: HTMLTableCellElement): HTMLTableCellElement {
    this.cells.set(JSON.stringify([state, event]), cell);
    return cell;
  }

  private mark(): void {
    const live = this.session.stateName(this.session.state.value);
    for (const [name, row] of this.rows) row.toggleAttribute("aria-current", name === live);
    const row = this.rows.get(live);
    if (row) this.reveal(row);
  }

  /** Scrolls the table alone, and only as far as it must. */
  private reveal(row: HTMLElement): void {
    const [top, bottom] = [row.offsetTop - 32, row.offsetTop + row.offsetHeight];
    if (top < this.host.scrollTop) this.host.scrollTop = top;
    else if (bottom > this.host.scrollTop + this.host.clientHeight) this.host.scrollTop = bottom - this.host.clientHeight;
  }

  /** Brings a cell into view sideways, beside the column that stays. */
  private revealSideways(cell: HTMLElement): void {
    const stays = this.table.querySelector<HTMLElement>("th")?.offsetWidth ?? 0;
    const [left, right] = [cell.offsetLeft - stays, cell.offsetLeft + cell.offsetWidth];
    if (left < this.host.scrollLeft) this.host.scrollLeft = left;
    else if (right > this.host.scrollLeft + this.host.clientWidth) this.host.scrollLeft = right - this.host.clientWidth;
  }

  private judge(verdict: Verdict): void {
    const cell = this.cells.get(JSON.stringify([verdict.from, verdict.event]));
    if (verdict.event === "END" && verdict.verdict !== "taken") return;
    say(this.line, verdictLine(verdict));
    this.line.dataset["verdict"] = verdict.verdict;
    if (!cell) return;
    if (verdict.verdict === "taken") {
      this.table.querySelector(".last")?.classList.remove("last");
      cell.classList.add("last");
      if (verdict.to && verdict.to !== verdict.from) this.revealSideways(cell);
    }
    flash(cell, verdict.verdict);
  }
}
