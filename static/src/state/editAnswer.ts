/** What the server says to an edit. */

import type { Finding } from "../net/protocol";

/** The answer to an edit. `stale`: another editor was first, and the machine was read again. */
export interface Answer {
  kind: "fine" | "refused" | "stale";
  words: string;
  findings: Finding[];
}

/** A cell of a layer. */
export interface CellPlace {
  layer: string;
  state: string;
  event: string;
}

/**
 * Returns the answer to a refused edit: the verifier's findings, or one with the reader's words, at the cell if the
 * edit is about one.
 */
export function refusal(words: string, findings: readonly Finding[], place: CellPlace | null): Answer {
  if (findings.length) return { kind: "refused", words, findings: [...findings] };
  const line = Number(/\bline (\d+)/.exec(words)?.[1] ?? 0);
  const message = words.replace(/^[^:]*\bline \d+: /, "");
  const { layer, state, event } = place ?? { layer: "", state: null, event: null };
  const finding = { kind: "refused", severity: "error" as const, message, subject: message };
  return {
    kind: "refused",
    words,
    findings: [{ ...finding, line, layer, state, event, replay: [], ticks: 0 }],
  };
}
