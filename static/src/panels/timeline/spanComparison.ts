/** The box that compares the selected span with one that was kept: the states of both, side by side, and the joints. */

import { html, type TemplateResult } from "lit-html";
import { laneKey } from "../../state/history";
import type { Span } from "../../state/timelineWindow";
import { draw } from "../../ui/draw";
import { popover } from "../../ui/popover";
import type { App } from "../../view/app";
import { compareSpans } from "./compareSpans";
import { spanJoints } from "./spanJoints";

const isSame = (one: Span | null, other: Span | null): boolean =>
  one?.from === other?.from && one?.to === other?.to;

/** Makes the button of the span bar, and its box. */
export function spanComparison(app: App): [HTMLElement, HTMLElement] {
  const { past, selection, stage, timeline } = app;
  const [button, box] = popover("compare", "compare with another span");
  const joints = spanJoints(app);
  box.addEventListener("toggle", () => {
    const [kept, selected] = [timeline.kept.value, timeline.selected.value];
    if (box.matches(":popover-open") && kept && selected && !isSame(kept, selected))
      void joints.ask(kept, selected);
  });

  function table(kept: Span, selected: Span): TemplateResult {
    const lane = laneKey(selection.actor.value ?? -1, selection.layer.value);
    const runsIn = (span: Span) => [span, past.runs.between(lane, span.from, span.to)] as const;
    const lines = compareSpans(runsIn(kept), runsIn(selected), stage.rate);
    const begin = ({ from }: Span): string => `from ${(from / stage.rate).toFixed(2)} s`;
    return html`<table class="span-comparison">
      <thead>
        <tr>
          <th scope="col" .textContent=${begin(kept)}></th>
          <th scope="col" .textContent=${begin(selected)}></th>
        </tr>
      </thead>
      <tbody>
        ${lines.map(
          ({ first, second, differs }) =>
            html`<tr class=${differs ? "differs" : ""}>
              <td .textContent=${first}></td>
              <td .textContent=${second}></td>
            </tr>`,
        )}
      </tbody>
    </table>`;
  }

  draw(box, () => {
    const [kept, selected] = [timeline.kept.value, timeline.selected.value];
    const keep = html`<button type="button" @click=${() => (timeline.kept.value = selected)}>
      keep this span
    </button>`;
    if (!kept || !selected)
      return html`<p>Keep this span, then select another one.</p>
        ${keep}`;
    if (isSame(kept, selected)) return html`<p>It is kept. Select another span, and compare again.</p>`;
    return html`${table(kept, selected)} ${keep} ${joints.drawn()}`;
  });
  return [button, box];
}
