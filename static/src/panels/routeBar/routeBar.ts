/** Shows the route of a travel step by step over the stage view, with a button that cancels it. */

import "./routeBar.css";
import type { App } from "../../view/app";
import { stepAt } from "../../state/travel";
import { el } from "../../ui/dom";

export function routeBarPanel(host: HTMLElement, { travel, selection }: App): void {
  let steps: HTMLElement[] = [];
  let at = 0;
  const mark = (): void => {
    const plan = travel.plan.value;
    if (!plan) return;
    at = stepAt(plan, selection.stateName(selection.state.value), at);
    steps.forEach((step, i) => step.toggleAttribute("aria-current", i === at));
  };
  travel.plan.subscribe((plan) => {
    host.hidden = plan === null;
    if (!plan) return;
    at = 0;
    steps = plan.steps.map(({ state, event, seconds }) => {
      const wait = event === "END" ? "waits for the end of the motion" : event;
      const title = `in ${state}: ${wait}, about ${seconds.toFixed(2)} s`;
      return el("li", { title }, state, el("small", {}, event === "END" ? "end" : event));
    });
    const cancel = el("button", { type: "button" }, "cancel");
    cancel.addEventListener("click", () => void travel.cancel());
    const title = el("strong", {}, `to ${plan.goal}`, el("small", {}, `about ${plan.seconds.toFixed(1)} s`));
    host.replaceChildren(title, el("ol", {}, ...steps, el("li", { class: "goal" }, plan.goal)), cancel);
    mark();
  });
  selection.state.subscribe(mark);
}
