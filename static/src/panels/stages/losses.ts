/** The part of the list that says what the last start of the server did not bring back. */

import { signal } from "@preact/signals-core";
import { html, nothing, type TemplateResult } from "lit-html";
import * as api from "../../net/stages";
import { keep, kept } from "../../state/kept";

const PLACE = "statwalk.losses";
const isText = (value: unknown): value is string => typeof value === "string";

/** Returns the part; `read` asks the server what it should say, and tells you once of something new. */
export function lossesPart(tell: (words: string) => void) {
  const said = signal<readonly string[]>([]);

  async function read(): Promise<void> {
    const losses = await api.losses().catch(() => null);
    if (!losses) return; // as for a link to one stage: what was said stays
    said.value = [...losses.stages.map(({ why }) => why), ...losses.other];
    const all = said.value.join("\n");
    if (all && all !== kept(PLACE, isText, ""))
      tell("The last start of the server did not bring all back. The list of stages (O) says what.");
    keep(PLACE, all);
  }

  const part = (): TemplateResult | typeof nothing =>
    said.value.length
      ? html`<section id="losses">
          <p>The last start of the server did not bring all back:</p>
          <ul>
            ${said.value.map((words) => html`<li .textContent=${words}></li>`)}
          </ul>
          <p>What is damaged stays in the data folder. <code>statwalk doctor</code> examines it.</p>
        </section>`
      : nothing;
  return { read, part };
}
