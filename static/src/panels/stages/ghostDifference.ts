/** The part of the list that compares the watched stage with its ghost, joint by joint. */

import { effect, signal } from "@preact/signals-core";
import { html, nothing, type TemplateResult } from "lit-html";
import type { StageDifferences } from "../../net/protocol";
import { reasonOf } from "../../net/reason";
import { differences } from "../../net/stages";
import { jointLines, comparedWords } from "../../state/jointLines";
import { jointTable } from "../../ui/jointTable";
import type { App } from "../../view/app";

/** How often the present is compared. */
const COMPARE_MS = 2000;

export function ghostDifference({ ghost, inspection, playback, selection, stage }: App) {
  const said = signal<StageDifferences | string | null>(null);
  let isAsking = false;

  /** Compares the shown tick, or the newest ticks while the page is live; one request at a time. */
  async function compare(): Promise<void> {
    const [other, tick, drawer] = [ghost.stage.value, playback.looking.value, inspection.drawer.value];
    if (other === null || isAsking || drawer !== "stages") return;
    isAsking = true;
    const span = tick === null ? {} : { from: tick, to: tick };
    const answer = await differences(stage.id, other, span).catch(reasonOf);
    isAsking = false;
    if (other !== ghost.stage.value || tick !== playback.looking.value) return compare();
    said.value = answer;
  }

  effect(() => {
    if (ghost.stage.value === null) said.value = null;
    void compare();
  });
  setInterval(() => playback.isLive && void compare(), COMPARE_MS);

  const first = (tick: number | null): TemplateResult | typeof nothing =>
    tick === null || tick === playback.looking.value
      ? nothing
      : html`<button
          type="button"
          .textContent=${`show tick ${tick}, the first that differs`}
          @click=${() => playback.look(tick)}
        ></button>`;

  return (): TemplateResult | typeof nothing => {
    const answer = said.value;
    if (ghost.stage.value === null) return nothing;
    if (answer === null) return html`<section id="difference"><p>comparing …</p></section>`;
    if (typeof answer === "string")
      return html`<section id="difference"><p .textContent=${answer}></p></section>`;
    const lines = jointLines(answer, selection.actor.value);
    return html`<section id="difference" aria-label="difference by joint">
      <p .textContent=${comparedWords(answer, lines.length)}></p>
      ${first(answer.first_difference)} ${jointTable(lines)}
    </section>`;
  };
}
