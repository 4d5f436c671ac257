/** Writes a cell: short for the table, in sentences for the tooltip, and as typed by its author. */

import type { Cell, LayerInfo } from "../../net/protocol";

/** A cell in short. */
export interface Glance {
  /** `WALK`; `WALK!` if the motion restarts; `–` if the event means nothing; empty if the cell is blank. */
  to: string;
  /** Number of alternatives. */
  others: number;
  /** Signs for the timing, the entry phase and an action. */
  signs: string[];
}

const number = (value: number): string => String(Number(value.toFixed(3))).replace(/^0\./, ".");

/** `⇥` at the end, `⟂ left-down` at a marker, `◫ .2–.6` in a window. */
export function momentSign(when: string): string {
  if (when === "now") return "";
  if (when === "end") return "⇥";
  const [kind = "", ...rest] = when.split(" ");
  if (kind === "marker") return `⟂ ${rest.join(" ")}`;
  const window = /([\d.]+?)\.\.([\d.]+)/.exec(when);
  return window ? `◫ ${number(Number(window[1]))}–${number(Number(window[2]))}` : when;
}

function enterSign(enter: Cell["enter"]): string {
  if (enter === "match") return "≈";
  return enter > 0 ? `↦${number(enter)}` : "";
}

const saysNothing = (cell: Cell): boolean => cell.to === null && !cell.alternatives.length;

export function glance(cell: Cell | undefined): Glance {
  if (!cell) return { to: "", others: 0, signs: [] };
  if (saysNothing(cell)) return { to: "–", others: 0, signs: [] };
  const { alternatives } = cell;
  const acts = cell.action || alternatives.some(({ action }) => action);
  const signs = [momentSign(cell.when), enterSign(cell.enter), acts ? "◆" : ""].filter(Boolean);
  return { to: cell.restart ? `${cell.to}!` : (cell.to ?? ""), others: alternatives.length, signs };
}

export function isDefault(cell: Cell): boolean {
  return cell.source !== "cell";
}

/** Writes a line for each alternative: `JUMP if stamina > 10, blend 0.25 s`, `STAT 75 %`. */
export function alternativeLines({ alternatives }: Cell): string[] {
  const total = alternatives.reduce((sum, { weight }) => sum + (weight ?? 0), 0);
  return alternatives.map(({ to, restart, condition, weight, blend, action }, i) => {
    const chance = weight !== null && total > 0 ? `${Number(((100 * weight) / total).toFixed(1))} %` : "";
    const otherwise = !condition && !chance && i > 0 ? "otherwise" : "";
    const way = [condition ? `if ${condition}` : otherwise, chance].filter(Boolean).join(" ");
    return [
      `${to}${restart ? "!" : ""} ${way}`.trim(),
      `blend ${blend.toFixed(2)} s`,
      action ? `action ${action}` : "",
    ]
      .filter(Boolean)
      .join(", ");
  });
}

/** Describes a cell, for the tooltip. */
export function cellSentence(state: string, event: string, cell: Cell | undefined): string {
  if (!cell) return `${state}, ${event}: blank, the event waits for its buffer`;
  const from = isDefault(cell) ? `from ${cell.source} ${cell.written.join("/")}` : "";
  if (saysNothing(cell)) return [`${state}, ${event}: means nothing here`, from].filter(Boolean).join(", ");
  const when =
    cell.when !== "now"
      ? cell.when.startsWith("window")
        ? `in the ${cell.when}`
        : `at ${cell.when}`
      : "at once";
  const lines = alternativeLines(cell);
  if (lines.length)
    return [`${state}, ${event}: ${[when, from].filter(Boolean).join(", ")}`, ...lines].join("\n");
  const facts = [
    when,
    cell.blend ? `blend ${cell.blend.toFixed(2)} s` : "",
    cell.restart ? "restarts the motion" : "",
    cell.enter === "match"
      ? "entered at the same phase"
      : cell.enter > 0
        ? `entered at ${number(cell.enter)}`
        : "",
    cell.action ? `action ${cell.action}` : "",
    from,
  ];
  return `${state}, ${event} → ${cell.to}: ${facts.filter(Boolean).join(", ")}`;
}

/** Returns the text that you would type for this cell; empty if nothing is written there. */
export function writtenText({ rows, table }: LayerInfo, state: string, event: string): string {
  const column = rows[0]?.indexOf(event) ?? -1;
  const row = column > 0 ? rows.find(([name]) => name === state) : undefined;
  if (row) return row[column] ?? "";
  const cell = table[state]?.[event];
  if (!cell || isDefault(cell) || cell.alternatives.length) return "";
  if (saysNothing(cell)) return "-";
  const moment = /^(?:end|marker (.+))$/.exec(cell.when);
  return `${cell.to}${cell.restart ? "!" : ""}${moment ? ` at ${moment[1] ?? "end"}` : ""}`;
}
