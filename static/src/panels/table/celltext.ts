/** What a cell says: at a glance, in sentences, and as one writes it in the table. */

import type { Cell, LayerInfo } from "../../net/protocol";

/** A cell at a glance. */
export interface Glance {
  /** `WALK`, `WALK!` where the motion starts again, `–` where the event means nothing, or nothing at all. */
  to: string;
  /** How many more ways out there are. */
  others: number;
  /** When it fires, where the motion is entered, whether an action comes with it. */
  signs: string[];
}

const number = (value: number): string => String(Number(value.toFixed(3))).replace(/^0\./, ".");

/** `⇥` at the end, `⟂ left-down` at a marker, `◫ .2–.6` within a window. */
export function momentSign(when: string | undefined): string {
  if (!when || when === "now") return "";
  if (when === "end") return "⇥";
  const [kind = "", ...rest] = when.split(" ");
  if (kind === "marker") return `⟂ ${rest.join(" ")}`;
  const window = /([\d.]+?)\.\.([\d.]+)/.exec(when);
  return window ? `◫ ${number(Number(window[1]))}–${number(Number(window[2]))}` : when;
}

function enterSign(enter: Cell["enter"]): string {
  if (enter === "match" || enter === -2) return "≈";
  return typeof enter === "number" && enter > 0 ? `↦${number(enter)}` : "";
}

const saysNothing = (cell: Cell): boolean => (cell.to === null || cell.to === "-") && !cell.alternatives?.length;

export function glance(cell: Cell | null | undefined): Glance {
  if (!cell) return { to: "", others: 0, signs: [] };
  if (saysNothing(cell)) return { to: "–", others: 0, signs: [] };
  const several = cell.alternatives ?? [];
  const acts = cell.action || several.some((one) => one.action);
  const signs = [momentSign(cell.when), enterSign(cell.enter), acts ? "◆" : ""].filter(Boolean);
  return { to: cell.restart ? `${cell.to}!` : (cell.to ?? ""), others: several.length, signs };
}

export function isDefault(cell: Cell): boolean {
  return cell.source !== undefined && cell.source !== "cell";
}

/** The ways out of a cell that has several, a line for each: `JUMP if stamina > 10, blend 0.25 s`, `STAT 75 %`. */
export function outcomeLines({ alternatives = [] }: Cell): string[] {
  const total = alternatives.reduce((sum, { weight }) => sum + (weight ?? 0), 0);
  return alternatives.map(({ to, restart, condition, weight, blend, action }, i) => {
    const chance = weight !== null && total > 0 ? `${Number(((100 * weight) / total).toFixed(1))} %` : "";
    const otherwise = !condition && !chance && i > 0 ? "otherwise" : "";
    const way = [condition ? `if ${condition}` : otherwise, chance].filter(Boolean).join(" ");
    return [`${to}${restart ? "!" : ""} ${way}`.trim(), `blend ${blend.toFixed(2)} s`, action ? `action ${action}` : ""].filter(Boolean).join(", ");
  });
}

/** A cell in sentences, for the tooltip. */
export function cellSentence(state: string, event: string, cell: Cell | null | undefined): string {
  if (!cell) return `${state}, ${event}: blank, the event waits for its buffer`;
  const from = isDefault(cell) ? `from ${cell.source}${cell.written ? ` ${cell.written.join("/")}` : ""}` : "";
  if (saysNothing(cell)) return [`${state}, ${event}: means nothing here`, from].filter(Boolean).join(", ");
  const when = cell.when && cell.when !== "now" ? (cell.when.startsWith("window") ? `in the ${cell.when}` : `at ${cell.when}`) : "at once";
  const several = outcomeLines(cell);
  if (several.length) return [`${state}, ${event}: ${[when, from].filter(Boolean).join(", ")}`, ...several].join("\n");
  const facts = [
    when,
    cell.blend ? `blend ${cell.blend.toFixed(2)} s` : "",
    cell.restart ? "starts the motion again" : "",
    cell.enter === "match" ? "entered at the same phase" : typeof cell.enter === "number" && cell.enter > 0 ? `entered at ${number(cell.enter)}` : "",
    cell.action ? `action ${cell.action}` : "",
    from,
  ];
  return `${state}, ${event} → ${cell.to}: ${facts.filter(Boolean).join(", ")}`;
}

/** What stands in the table at `state`, `event`, as one would type it; empty where nothing is written there. */
export function writtenText({ rows, table }: LayerInfo, state: string, event: string): string {
  const column = rows[0]?.indexOf(event) ?? -1;
  const row = column > 0 ? rows.find(([name]) => name === state) : undefined;
  if (row) return row[column] ?? "";
  const cell = table[state]?.[event];
  if (!cell || isDefault(cell) || cell.alternatives?.length) return "";
  if (saysNothing(cell)) return "-";
  const moment = /^(?:end|marker (.+))$/.exec(cell.when ?? "");
  return `${cell.to}${cell.restart ? "!" : ""}${moment ? ` at ${moment[1] ?? "end"}` : ""}`;
}
