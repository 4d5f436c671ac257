/** Shows the route of a travel step by step over the stage view, with a button that cancels it. */

import "./routeBar.css";
import { html, noChange } from "lit-html";
import type { Plan } from "../../net/protocol";
import { stepAt } from "../../state/travel";
import { draw } from "../../ui/draw";
import type { App } from "../../view/app";

export function routeBarPanel(host: HTMLElement, { travel, selection }: App): void {
  let shown: Plan | null = null;
  let at = 0;
  draw(host, () => {
    const plan = travel.plan.value;
    host.hidden = plan === null;
    if (!plan) return noChange;
    at = stepAt(plan, selection.stateName(selection.state.value), plan === shown ? at : 0);
    shown = plan;
    const steps = plan.steps.map(({ state, event, seconds }, i) => {
      const wait = event === "END" ? "waits for the end of the motion" : event;
      const title = `in ${state}: ${wait}, about ${seconds.toFixed(2)} s`;
      return html`<li title=${title} ?aria-current=${i === at}>
        ${state}<small .textContent=${event === "END" ? "end" : event}></small>
      </li>`;
    });
    return html`<strong>to ${plan.goal}<small>about ${plan.seconds.toFixed(1)} s</small></strong>
      <ol>
        ${steps}
        <li class="goal" .textContent=${plan.goal}></li>
      </ol>
      <button type="button" @click=${() => void travel.cancel()}>cancel</button>`;
  });
}
