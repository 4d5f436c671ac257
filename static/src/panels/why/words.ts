/** Puts explanations into words. */

import type { Explained } from "../../net/protocol";

/** Writes the values that a condition read: `stamina 5`, `speed 1.42`. */
export function valueWords(values: Record<string, number>): string[] {
  return Object.entries(values).map(([name, value]) => `${name} ${Number(value.toPrecision(4))}`);
}

/** Writes the result of a verdict: `WALK → CSTP`, `stays in WALK`, `waits in WALK`. */
export function resultWords({
  verdict,
  from_state: from,
  to_state: to,
}: Pick<Explained, "verdict" | "from_state" | "to_state">): string {
  if (verdict !== "taken") return `${verdict} in ${from}`;
  return to ? `${from} → ${to}` : `stays in ${from}`;
}

/** Writes the reason; empty if it says no more than the result. */
export const reasonWords = ({ reason }: Pick<Explained, "reason">): string =>
  reason === "stays" ? "" : reason;

/** Writes a blend: `0.25 s, cubic`; empty if no motion started. */
export function blendWords({
  blend_seconds: seconds,
  curve,
}: Pick<Explained, "blend_seconds" | "curve">): string {
  if (seconds === null) return "";
  return seconds > 0 ? `${seconds.toFixed(2)} s${curve ? `, ${curve}` : ""}` : "none: the motions meet";
}

/** Returns whether a joint moved visibly. */
export function isSeen({ degrees, millimetres }: { degrees: number; millimetres: number }): boolean {
  return degrees >= 0.05 || millimetres >= 0.5;
}

/** Writes how far a joint moved: `12.4°`, `12.4° 30 mm`. */
export function movedWords({ degrees, millimetres }: { degrees: number; millimetres: number }): string {
  const turned = degrees >= 0.05 || millimetres < 0.5 ? `${degrees.toFixed(1)}°` : "";
  return [turned, millimetres >= 0.5 ? `${millimetres.toFixed(0)} mm` : ""].filter(Boolean).join(" ");
}

/** Returns the label of a remedy's button; empty if the remedy has none. */
export function trialWords(kind: string): string {
  return (
    {
      cell: "edit the cell",
      set: "set it now",
      state: "go there now",
      send: "send it now",
      moment: "look there",
    }[kind] ?? ""
  );
}
