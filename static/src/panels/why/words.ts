/** Verdicts and remedies in words. */

import type { Explained } from "../../net/explained";
import type { Verdict } from "../../net/protocol";

/** What became of an event, in one line. */
export function verdictLine({ verdict, event, from, to, reason }: Verdict): string {
  const taken = to ? `${from ?? ""} → ${to}` : `stays in ${from ?? "?"}`;
  const way = verdict === "taken" ? taken : `${verdict} in ${from ?? "?"}`;
  return reason && verdict !== "taken" ? `${event}: ${way}, ${reason}` : `${event}: ${way}`;
}

/** What a condition saw: `stamina 5`, `speed 1.42`. */
export function valueWords(values: Record<string, number>): string[] {
  return Object.entries(values).map(([name, value]) => `${name} ${Number(value.toPrecision(4))}`);
}

/** Where a verdict led to, in words: `WALK → CSTP`, `stays in WALK`, `waits in WALK`. */
export function outcomeWords({ verdict, from_state: from, to_state: to }: Pick<Explained, "verdict" | "from_state" | "to_state">): string {
  if (verdict !== "taken") return `${verdict} in ${from}`;
  return to ? `${from} → ${to}` : `stays in ${from}`;
}

/** The blend of a motion that began: `0.25 s, cubic`; empty where none began. */
export function blendWords({ blend_seconds: seconds, curve }: Pick<Explained, "blend_seconds" | "curve">): string {
  if (seconds === null) return "";
  return seconds > 0 ? `${seconds.toFixed(2)} s${curve ? `, ${curve}` : ""}` : "none: the motions meet";
}

/** Whether a joint had to go far enough for an eye to see it. */
export function isSeen({ degrees, millimetres }: { degrees: number; millimetres: number }): boolean {
  return degrees >= 0.05 || millimetres >= 0.5;
}

/** How far a joint had to go: `12.4°`, `12.4° 30 mm`. */
export function movedWords({ degrees, millimetres }: { degrees: number; millimetres: number }): string {
  const turned = degrees >= 0.05 || millimetres < 0.5 ? `${degrees.toFixed(1)}°` : "";
  return [turned, millimetres >= 0.5 ? `${millimetres.toFixed(0)} mm` : ""].filter(Boolean).join(" ");
}

/** What trying a remedy of this kind is called; empty where it cannot be tried from here. */
export function trialWords(kind: string): string {
  return { cell: "edit the cell", set: "set it now", state: "go there now", send: "send it now", moment: "look there" }[kind] ?? "";
}
