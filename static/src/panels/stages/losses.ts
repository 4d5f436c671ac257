/** The part of the list that says what the last start of the server did not bring back. */

import { signal } from "@preact/signals-core";
import { html, nothing, type TemplateResult } from "lit-html";
import * as api from "../../net/stages";

/** Returns the part; `read` asks the server what it should say. */
export function lossesPart() {
  const said = signal<readonly string[]>([]);

  async function read(): Promise<void> {
    const { stages, other } = await api.losses();
    said.value = [...stages.map(({ why }) => why), ...other];
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
