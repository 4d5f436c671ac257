/** Says how alike left and right move in a clip: twins look stiff, and an animator offsets them. */

import { html, nothing, render, type TemplateResult } from "lit-html";
import { keyed } from "lit-html/directives/keyed.js";
import * as api from "../../net/api";
import { reasonOf } from "../../net/reason";

type Report = Awaited<ReturnType<typeof api.twinning>>;

/** The report of a clip, read when it is opened. */
export function twins(character: string, clip: string): TemplateResult {
  const opened = ({ currentTarget }: Event): void => {
    const details = currentTarget as HTMLDetailsElement;
    if (details.open) void show(details.querySelector("div")!, character, clip);
  };
  return html`${keyed(
    `${character} ${clip}`,
    html`<details class="twins" @toggle=${opened}>
      <summary>left and right</summary>
      <div role="status"></div>
    </details>`,
  )}`;
}

async function show(host: HTMLElement, character: string, clip: string): Promise<void> {
  try {
    render(report(await api.twinning(character, clip)), host);
  } catch (error) {
    render(html`<p .textContent=${reasonOf(error)}></p>`, host);
  }
}

/** The pairs that move, the most alike first. */
export function report({ pairs, alone }: Report): TemplateResult {
  const twinned = pairs.filter((pair) => pair.twinned).length;
  return html`<p .textContent=${summary(pairs.length, twinned)}></p>
    ${pairs.length ? table(pairs) : nothing}
    ${alone.length ? html`<p .textContent=${`without a partner: ${alone.join(", ")}`}></p>` : nothing}`;
}

function summary(pairs: number, twinned: number): string {
  if (!pairs) return "no pair of left and right moves";
  if (!twinned) return `none of ${pairs} pairs does the same at the same moment`;
  return `${twinned} of ${pairs} pairs ${twinned === 1 ? "does" : "do"} the same at the same moment`;
}

function table(pairs: Report["pairs"]): TemplateResult {
  return html`<table>
    <thead>
      <tr>
        <th scope="col">left, right</th>
        <th scope="col" title="1: the same, 0: nothing in common, −1: opposite">alike</th>
        <th scope="col" title="how far they turn from their mean">turn</th>
      </tr>
    </thead>
    <tbody>
      ${pairs.map(
        ({ left, right, alike, swing_deg, twinned }) =>
          html`<tr class=${twinned ? "twinned" : ""}>
            <th scope="row" .textContent=${`${left}, ${right}`}></th>
            <td .textContent=${alike.toFixed(2)}></td>
            <td .textContent=${`${swing_deg.toFixed(1)}°`}></td>
          </tr>`,
      )}
    </tbody>
  </table>`;
}
