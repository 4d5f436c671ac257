/** Reads a cell for a form, and writes its fields as operations. */

import type { Cell, LayerInfo, Operation } from "../../net/protocol";
import type { CellPlace } from "../../state/editAnswer";

type SetCell = Extract<Operation, { kind: "set_cell" }>;
type CellFields = NonNullable<SetCell["fields"]>;

/** Returns the cell at a place; `*` as state or event: the default of a column or row, from any cell that has it. */
export function cellOf({ table }: LayerInfo, { state, event }: CellPlace): Cell | undefined {
  if (state !== "*" && event !== "*") return table[state]?.[event];
  const cells = Object.values(table).flatMap((row) => Object.values(row));
  return cells.find(({ source, written }) => source !== "cell" && written.join("/") === `${state}/${event}`);
}

/** Returns whether a cell says something of its own at this place. */
export const isWritten = (cell: Cell | undefined, { state, event }: CellPlace): boolean =>
  cell !== undefined && (cell.source === "cell" || cell.written.join("/") === `${state}/${event}`);

/** Returns what a cell leads to, as it is typed: "" blank, "-" nothing, "WALK!" from its beginning. */
export function targetText(cell: Cell | undefined): string {
  if (!cell) return "";
  if (cell.to === null) return cell.alternatives.length ? "" : "-";
  return cell.restart ? `${cell.to}!` : cell.to;
}

/** Writes a target with a moment that has a place in the table: `WALK at end`, `WALK at left-down`. */
export function withMoment(target: string, when: string): string {
  if (target === "" || target === "-") return target;
  const moment = when === "end" ? "end" : /^marker (.+)$/.exec(when)?.[1];
  return moment === undefined ? target : `${target} at ${moment}`;
}

export const setFields = (place: CellPlace, fields: CellFields): Operation[] => [
  { kind: "set_cell", ...place, fields },
];

export const setTarget = (place: CellPlace, cell: Cell | undefined, target: string): Operation[] => [
  {
    kind: "set_cell",
    ...place,
    text: withMoment(target, cell?.when ?? "now"),
    ...(cell?.alternatives.length && { fields: { alternatives: null } }),
  },
];

/** Sets when a cell fires: at the end and at a marker in the table, at a window below `cells`. */
export function setWhen(place: CellPlace, cell: Cell, when: string): Operation[] {
  const inTable = withMoment(targetText(cell), when);
  const hasMoment = inTable !== targetText(cell);
  if (cell.alternatives.length) return setFields(place, { when });
  return [{ kind: "set_cell", ...place, text: inTable, fields: { when: hasMoment ? null : when } }];
}

/** Reads seconds. :throws: if the text is no number, in words for the user. */
export function seconds(text: string): number {
  const value = Number(text);
  if (!text.trim() || !(value >= 0)) throw new Error("seconds: a number, 0 or greater");
  return value;
}

export const blendField = (value: number, curve: Cell["curve"]): CellFields["blend"] =>
  curve === "cubic" ? value : { seconds: value, curve };

/** Reads a phase from 0 to 1, or `match`. */
export function enterField(text: string): CellFields["enter"] {
  if (!text.trim()) return null;
  if (text === "match") return "match";
  const phase = Number(text);
  if (!(phase >= 0 && phase <= 1)) throw new Error("a phase from 0 to 1, or match");
  return phase;
}

/** An alternative, as its fields show it. */
export interface AlternativeText {
  to: string;
  condition: string;
  weight: string;
}

export const alternativeTexts = (cell: Cell): AlternativeText[] =>
  cell.alternatives.map(({ to, restart, condition, weight }) => ({
    to: restart ? `${to}!` : to,
    condition,
    weight: weight === null ? "" : String(weight),
  }));

/** Sets the alternatives of a cell: by conditions, or (as soon as one has a weight) by chance. */
export function setAlternatives(
  place: CellPlace,
  cell: Cell | undefined,
  texts: readonly AlternativeText[],
): Operation[] {
  if (!texts.length) return [{ kind: "set_cell", ...place, text: "", fields: { alternatives: null } }];
  if (texts.some(({ weight }) => weight))
    return setFields(place, {
      alternatives: Object.fromEntries(texts.map(({ to, weight }) => [to, Number(weight || 1)])),
    });
  return setFields(place, {
    alternatives: texts.map(({ to, condition }, i) => {
      const old = cell?.alternatives[i];
      return alternativeField(to, condition, old?.blend ?? cell?.blend ?? 0, old ?? cell);
    }),
  });
}

/** Writes an alternative; what it does not say is left out. */
export function alternativeField(
  to: string,
  condition: string,
  blend: number,
  old: Pick<Cell, "curve" | "enter" | "action"> | undefined,
) {
  return {
    to,
    ...(condition && { if: condition }),
    blend: blendField(blend, old?.curve ?? "cubic") ?? blend,
    ...(old?.enter ? { enter: old.enter } : {}),
    ...(old?.action ? { action: old.action } : {}),
  };
}
