/** Draws the table: cells, rows, and the head of each sub-machine. */

import type { Cell, LayerInfo, StateInfo } from "../../net/protocol";
import { around } from "../../state/folds";
import { el, svg } from "../../ui/dom";
import { cellSentence, glance, isDefault } from "./cellText";
import type { Line } from "./tableBody";

function fork(count: number): HTMLElement {
  const drawing = svg(
    "svg",
    { viewBox: "0 0 12 12", width: 11, height: 11, "aria-hidden": true },
    svg("path", {
      d: "M1 6h3M4 6l5-3.5M4 6l5 3.5",
      fill: "none",
      stroke: "currentColor",
      "stroke-width": 1.4,
      "stroke-linecap": "round",
    }),
  );
  return el("span", { class: "fork", "aria-label": `${count} ways` }, drawing, String(count));
}

function cellClasses(state: string, cell: Cell | undefined, known: ReadonlySet<string>): string {
  const classes = [
    cell && isDefault(cell) ? "default" : "",
    cell?.to === state ? "stay" : "",
    cell?.to && !known.has(cell.to) ? "undefined" : "",
    cell && glance(cell).to === "–" ? "off" : "",
  ];
  return classes.filter(Boolean).join(" ");
}

export function drawCell(
  { name: state, outer }: StateInfo,
  event: string,
  cell: Cell | undefined,
  known: ReadonlySet<string>,
): HTMLTableCellElement {
  const { to, others, signs } = glance(cell);
  // A sibling in a sub-machine has its short name, as in the file.
  const near = outer && to.startsWith(`${outer}.`) ? to.slice(outer.length + 1) : to;
  const parts = [
    el("span", { class: "to" }, near),
    others > 1 ? fork(others) : null,
    ...signs.map((sign) => el("small", {}, sign)),
  ];
  const place = { "data-state": state, "data-column": event, tabindex: -1 };
  return el(
    "td",
    {
      class: cellClasses(state, cell, known),
      title: cellSentence(state, event, cell),
      role: "gridcell",
      ...place,
    },
    ...parts,
  );
}

/** Draws the head of a state's row; its button travels to the state. */
export function drawState(
  { name, outer, motion, duration, loop }: StateInfo,
  goTo: ((state: string) => void) | null,
): HTMLTableCellElement {
  const short = outer ? name.slice(outer.length + 1) : name;
  const facts = motion === null ? "no motion" : `${motion}, ${duration.toFixed(2)} s${loop ? ", loops" : ""}`;
  const head = el(
    "th",
    {
      scope: "row",
      role: "rowheader",
      title: `${name}: ${facts}`,
      class: outer ? "inner" : undefined,
      "data-state": name,
      tabindex: -1,
      "aria-haspopup": "menu",
    },
    short,
  );
  if (!goTo) return head;
  const arrow = svg(
    "svg",
    { viewBox: "0 0 12 12", width: 12, height: 12, "aria-hidden": true },
    svg("path", {
      d: "M2 6h7M6 3l3 3-3 3",
      fill: "none",
      stroke: "currentColor",
      "stroke-width": 1.5,
      "stroke-linecap": "round",
      "stroke-linejoin": "round",
    }),
  );
  const button = el(
    "button",
    {
      type: "button",
      class: "go",
      tabindex: -1,
      "aria-label": `go to ${name}`,
      title: `travel to ${name} by the fastest events`,
    },
    arrow,
  );
  button.addEventListener("click", () => goTo(name));
  head.append(button);
  return head;
}

/** Returns the events that have a cell in this layer, in the order of the machine. */
export function columns(layer: LayerInfo, events: readonly string[]): string[] {
  const written = new Set(layer.rows[0] ?? []);
  return events.filter(
    (event) => written.has(event) || layer.states.some(({ name }) => layer.table[name]?.[event]),
  );
}

const COLUMN = { scope: "col", role: "columnheader", tabindex: -1, "aria-haspopup": "menu" };

/** Draws the head of the columns. */
export function drawHead(shown: readonly string[]): HTMLTableRowElement {
  const corner = { ...COLUMN, class: "corner", title: "add a state or an event" };
  return el(
    "tr",
    { "aria-rowindex": 1 },
    el("th", corner, "state", el("b", {}, "+")),
    ...shown.map((event) => el("th", { ...COLUMN, "data-column": event }, event)),
  );
}

/** What the lines of a table need beside the layer. */
export interface Lines {
  /** What stands for each state: itself, or a folded sub-machine. */
  shown: ReadonlyMap<string, string>;
  fold: (name: string, isFolded: boolean) => void;
  /** Travels to a state; null: not in this layer. */
  goTo: ((state: string) => void) | null;
}

/** Returns the lines of a layer's states; states of a sub-machine come under its name, unless it is folded. */
export function linesOf(
  layer: LayerInfo,
  states: readonly StateInfo[],
  events: readonly string[],
  { shown, fold, goTo }: Lines,
): Line[] {
  const known = new Set(layer.states.map((state) => state.name));
  const lines: Line[] = [];
  let before: string[] = [];
  for (const state of states) {
    const name = shown.get(state.name) ?? state.name;
    const isFolded = name !== state.name;
    const heads = [...(isFolded ? [name] : []), ...around(layer, name)].reverse();
    const added = heads.filter((outer, depth) => outer !== before[depth]);
    lines.push(...added.map((outer) => headLine(layer, outer, outer === name, events.length + 1, fold)));
    if (!isFolded) lines.push(rowLine(layer, state, events, known, goTo));
    before = heads;
  }
  return lines;
}

function rowLine(
  { table }: LayerInfo,
  state: StateInfo,
  events: readonly string[],
  known: ReadonlySet<string>,
  goTo: Lines["goTo"],
): Line {
  const row = table[state.name];
  const cells = (): HTMLElement[] => events.map((event) => drawCell(state, event, row?.[event], known));
  const isKnown = (event: string): boolean => known.has(row?.[event]?.to ?? "");
  return {
    name: state.name,
    isState: true,
    text: () => JSON.stringify([state, goTo !== null, events, row, events.map(isKnown)]),
    draw: () => el("tr", {}, drawState(state, goTo), ...cells()),
  };
}

/** The head of a sub-machine: a button that folds it. */
function headLine(
  { states }: LayerInfo,
  outer: string,
  isFolded: boolean,
  columns: number,
  fold: Lines["fold"],
): Line {
  const inner = states.filter(({ name }) => name.startsWith(`${outer}.`)).length;
  const words = isFolded ? `${outer}, ${inner} ${inner === 1 ? "state" : "states"}` : outer;
  const draw = (): HTMLTableRowElement => {
    const button = el(
      "button",
      { type: "button", class: "fold", "aria-expanded": String(!isFolded), "data-fold": outer },
      words,
    );
    button.addEventListener("click", () => fold(outer, !isFolded));
    return el("tr", { class: "outer" }, el("th", { colspan: columns }, button));
  };
  return {
    name: isFolded ? outer : "",
    isState: false,
    text: () => JSON.stringify([words, isFolded, columns]),
    draw,
  };
}

/** Returns the number of letters of the longest text in each column. */
export function columnLetters({ table }: LayerInfo, shown: readonly string[]): number[] {
  const rows = Object.values(table);
  const letters = (cell: Cell | undefined): number => {
    const { to, signs } = glance(cell);
    return to.length + 2 * signs.length;
  };
  return shown.map((event) => Math.max(event.length, ...rows.map((row) => letters(row[event]))));
}

/** Makes each column as wide as its longest text in any row: rows that come into sight do not widen it. */
export function keepWidths({ cells }: HTMLTableRowElement, layer: LayerInfo, shown: readonly string[]): void {
  const longest = Math.max(...layer.states.map(({ name }) => name.length));
  [longest, ...columnLetters(layer, shown)].forEach((letters, i) => {
    cells[i]!.style.minWidth = `${letters}ch`;
  });
}
