/** How far the joints are apart in two spans, tick by tick from where each begins. */

import { signal } from "@preact/signals-core";
import { html, nothing, type TemplateResult } from "lit-html";
import type { StageDifferences } from "../../net/protocol";
import { reasonOf } from "../../net/reason";
import { differences } from "../../net/stages";
import { jointLines, comparedWords } from "../../state/jointLines";
import type { Span } from "../../state/timelineWindow";
import { jointTable } from "../../ui/jointTable";
import type { App } from "../../view/app";

/** Returns what asks for the differences of two spans, and what draws them; the shorter span counts. */
export function spanJoints({ selection, stage }: App) {
  const said = signal<StageDifferences | string | null>(null);
  let newest: Promise<StageDifferences | string> | null = null;

  async function ask(kept: Span, selected: Span): Promise<void> {
    said.value = null;
    const length = Math.min(kept.to - kept.from, selected.to - selected.from);
    const ticks = { from: kept.from, to: kept.from + length, with_from: selected.from };
    // In model space, so that a walker who has come farther is still the same walker.
    const asked = (newest = differences(stage.id, stage.id, { ...ticks, space: "model" }).catch(reasonOf));
    const answer = await asked;
    if (asked === newest) said.value = answer;
  }

  function drawn(): TemplateResult | typeof nothing {
    const answer = said.value;
    if (answer === null) return html`<p>comparing …</p>`;
    if (typeof answer === "string") return html`<p .textContent=${answer}></p>`;
    const lines = jointLines(answer, selection.actor.value);
    return html`<p .textContent=${comparedWords(answer, lines.length)}></p>
      ${jointTable(lines)}`;
  }

  return { ask, drawn };
}
