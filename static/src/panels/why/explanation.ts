/** Shows the verdict on one event: cell, values, result, blend, joints. */

import { html, nothing, type TemplateResult } from "lit-html";
import type { Explained } from "../../net/protocol";
import { blendWords, isSeen, movedWords, reasonWords, resultWords, valueWords } from "./words";

type Part = TemplateResult | typeof nothing;

function joints({ joints: all }: Explained): TemplateResult | string {
  const moved = all.filter(isSeen);
  if (!moved.length) return "";
  const size = (joint: Explained["joints"][number]): number => joint.degrees + 0.1 * joint.millimetres;
  const most = Math.max(...moved.map(size), 1e-9);
  const width = (share: number): string => `width: ${Math.max(2, Math.round(100 * share))}%`;
  return html`<ul class="joints">
    ${moved.map(
      (joint) =>
        html`<li>
          <span .textContent=${joint.joint}></span>
          <span class="length">
            <i class="moved" aria-hidden="true" .style=${width(size(joint) / most)}></i>
          </span>
          <b .textContent=${movedWords(joint)}></b>
        </li>`,
    )}
  </ul>`;
}

function cellButton(
  { cell, line, source, from_state: state, event }: Explained,
  go: (state: string, event: string) => void,
): TemplateResult {
  if (!cell) return html`<span>no cell</span>`;
  const facts = [source && source !== "cell" ? source : "", line ? `line ${line}` : ""].filter(Boolean);
  return html`<button
      type="button"
      class="where"
      title="shows the cell in the table"
      .textContent=${cell.join("/")}
      @click=${() => go(state, event)}
    ></button>
    <small .textContent=${facts.join(", ")}></small>`;
}

const row = (term: string, part: TemplateResult | string): Part =>
  part
    ? html`<div>
        <dt>${term}</dt>
        <dd>${part}</dd>
      </div>`
    : nothing;

/** `layer`: its name if the machine has several, else empty. `go` shows a cell of the table. */
export function explanation(
  explained: Explained,
  layer: string,
  go: (state: string, event: string) => void,
): TemplateResult {
  const { event, verdict } = explained;
  return html`<section class="event-why" data-about=${event}>
    <h3>
      ${event}${layer ? html`<small .textContent=${layer}></small>` : nothing}
      <em data-verdict=${verdict} .textContent=${verdict}></em>
    </h3>
    <dl>
      ${row("cell", cellButton(explained, go))} ${row("values", valueWords(explained.values).join(", "))}
      ${row("so", resultWords(explained))} ${row("because", reasonWords(explained))}
      ${row("blend", blendWords(explained))} ${row("joints", joints(explained))}
    </dl>
  </section>`;
}
