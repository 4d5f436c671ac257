/** Reads a cell for a form, and writes its fields as operations. */

import type { Cell, LayerInfo, Operation } from "../../net/protocol";
import type { CellPlace } from "../../state/editAnswer";

type SetCell = Extract<Operation, { kind: "set_cell" }>;
type CellFields = NonNullable<SetCell["fields"]>;
type Fields = { [Member in keyof CellFields]-?: NonNullable<CellFields[Member]> };

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

/** What a cell, or one of its alternatives, says of the way to the next state. */
export type Transition = Pick<Cell, "blend" | "curve" | "enter" | "action">;

/** A change of a transition; null takes the member away. */
export interface TransitionChange {
  blend?: number;
  curve?: Cell["curve"];
  enter?: Cell["enter"] | null;
  action?: string | null;
}

/**
 * Sets fields of a cell. A cell that comes from a default becomes a cell of its own, which is as the default but for
 * these fields.
 */
export function setFields(place: CellPlace, cell: Cell, fields: CellFields): Operation[] {
  const hasAlternatives = "alternatives" in fields || cell.alternatives.length > 0;
  const text = isWritten(cell, place) || hasAlternatives ? {} : { text: targetText(cell) };
  return [{ kind: "set_cell", ...place, ...text, fields: { ...copied(place, cell), ...fields } }];
}

/** Returns what a cell that comes from a default says, so that another cell can say it; nothing of a written cell. */
function copied(place: CellPlace, cell: Cell): CellFields {
  if (isWritten(cell, place)) return {};
  const { when, blend, curve, enter, action } = cell;
  return {
    when,
    blend: { seconds: blend, curve },
    ...(enter && { enter }),
    ...(action && { action }),
    ...(cell.alternatives.length && { alternatives: alternativesField(cell, alternativeTexts(cell)) }),
  };
}

/** Sets members of a cell's transition; `curve` is the curve of a cell that names none. */
export function setTransition(
  place: CellPlace,
  cell: Cell,
  change: TransitionChange,
  curve: Cell["curve"],
): Operation[] {
  const { blend, curve: along, ...others } = change;
  const blends = blend !== undefined || along !== undefined;
  return setFields(place, cell, {
    ...(blends && { blend: blendField(blend ?? cell.blend, along ?? cell.curve, curve) }),
    ...others,
  });
}

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
  if (cell.alternatives.length) return setFields(place, cell, { when });
  const fields = { ...copied(place, cell), when: hasMoment ? null : when };
  return [{ kind: "set_cell", ...place, text: inTable, fields }];
}

/** Reads seconds. :throws: if the text is no number, in words for the user. */
export function seconds(text: string): number {
  const value = Number(text);
  if (!text.trim() || !(value >= 0)) throw new Error("seconds: a number, 0 or greater");
  return value;
}

/** Writes a blend; its curve is left out if it is the one that counts without. */
const blendField = (seconds: number, curve: Cell["curve"], without: Cell["curve"]): Fields["blend"] =>
  curve === without ? seconds : { seconds, curve };

/** Reads a phase from 0 to 1, or `match`. */
export function enterField(text: string): CellFields["enter"] {
  if (!text.trim()) return null;
  if (text === "match") return "match";
  const phase = Number(text);
  if (!(phase >= 0 && phase <= 1)) throw new Error("a phase from 0 to 1, or match");
  return phase;
}

/** An alternative, as its fields show it. */
export interface AlternativeText extends Transition {
  to: string;
  condition: string;
  weight: string;
}

export const alternativeTexts = (cell: Cell): AlternativeText[] =>
  cell.alternatives.map(({ to, restart, condition, weight, blend, curve, enter, action }) => ({
    to: restart ? `${to}!` : to,
    condition,
    weight: weight === null ? "" : String(weight),
    ...{ blend, curve, enter, action },
  }));

/** Sets the alternatives of a cell: by conditions, or (as soon as one has a weight) by chance. */
export const setAlternatives = (
  place: CellPlace,
  cell: Cell,
  texts: readonly AlternativeText[],
): Operation[] =>
  texts.length
    ? setFields(place, cell, { alternatives: alternativesField(cell, texts) })
    : [{ kind: "set_cell", ...place, text: "", fields: { alternatives: null } }];

function alternativesField(cell: Cell, texts: readonly AlternativeText[]): Fields["alternatives"] {
  if (texts.some(({ weight }) => weight))
    return Object.fromEntries(texts.map(({ to, weight }) => [to, Number(weight || 1)]));
  return texts.map((text) => alternativeField(cell, text));
}

/** Writes an alternative; what it has in common with the cell is left out. */
function alternativeField(cell: Cell, { to, condition, blend, curve, enter, action }: AlternativeText) {
  const blends = blend !== cell.blend || curve !== cell.curve;
  return {
    to,
    ...(condition && { if: condition }),
    ...(blends && { blend: blendField(blend, curve, cell.curve) }),
    ...(enter !== cell.enter && { enter }),
    ...(action && action !== cell.action && { action }),
  };
}
