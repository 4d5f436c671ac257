/** Lists the verifier's findings, new ones first. */

import { html, nothing, type TemplateResult } from "lit-html";
import type { Finding } from "../../net/protocol";

export interface MarkedFinding extends Finding {
  isNew: boolean;
}

/** Returns what is equal if two versions have the same finding. A property that was proved is new when it is refuted. */
const key = ({ severity, kind, layer, subject }: Finding): string =>
  JSON.stringify([severity, kind, layer, subject]);
const WEIGHT: Record<Finding["severity"], number> = { error: 0, warning: 1, info: 2 };

/** Marks the findings that `before` does not have as new; sorts new before old, errors before warnings. */
export function marked(before: readonly Finding[], now: readonly Finding[]): MarkedFinding[] {
  const known = new Set(before.map(key));
  const all = now.map((finding) => ({ ...finding, isNew: !known.has(key(finding)) }));
  return all.sort((a, b) => Number(b.isNew) - Number(a.isNew) || WEIGHT[a.severity] - WEIGHT[b.severity]);
}

/** Counts the findings of `before` that are gone; not those about budgets, as `now` has not been measured. */
export function fixed(before: readonly Finding[], now: readonly Finding[]): number {
  const left = new Set(now.map(key));
  const verified = before.filter(({ severity, kind }) => severity !== "info" && kind !== "budget");
  return verified.filter((finding) => !left.has(key(finding))).length;
}

/** Counts in words: "2 errors, 1 warning", "nothing is wrong"; null: the verifier has not answered. */
export function countWords(findings: readonly Finding[] | null): string {
  if (!findings) return "not known yet";
  const words = (["error", "warning"] as const).map((severity) => {
    const count = findings.filter((finding) => finding.severity === severity).length;
    return count ? `${count} ${severity}${count > 1 ? "s" : ""}` : "";
  });
  return words.filter(Boolean).join(", ") || "nothing is wrong";
}

/** Makes the list of findings; `go` shows a finding's cell, or its line of the file. */
export function findingItems(
  findings: readonly MarkedFinding[],
  go: (finding: Finding) => void,
): TemplateResult[] {
  return findings.map((finding) => {
    const { severity, message, line, state, event, isNew } = finding;
    const place = [state && event ? `${state}/${event}` : (state ?? ""), line ? `line ${line}` : ""]
      .filter(Boolean)
      .join(", ");
    const where = html`<button
      type="button"
      class="where"
      .textContent=${place}
      @click=${() => go(finding)}
    ></button>`;
    return html`<li data-severity=${severity} class=${isNew ? "new" : nothing}>
      <i class="severity" aria-hidden="true"></i>
      <span class="said"><b>${isNew ? "new " : ""}${severity}: </b>${message}</span>
      ${place ? where : null}
    </li>`;
  });
}
