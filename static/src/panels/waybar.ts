/** Over the picture: the way to a state, step by step, and a button that cancels it. */

import type { Session } from "../session";
import { type Travelling, stepAt } from "../travelling";
import { el } from "./dom";

export function wayBar(host: HTMLElement, session: Session, travelling: Travelling): void {
  let steps: HTMLElement[] = [];
  let at = 0;
  const mark = (): void => {
    const plan = travelling.plan.value;
    if (!plan) return;
    at = stepAt(plan, session.stateName(session.state.value), at);
    steps.forEach((step, i) => step.toggleAttribute("aria-current", i === at));
  };
  travelling.plan.on((plan) => {
    host.hidden = plan === null;
    if (!plan) return;
    at = 0;
    steps = plan.steps.map(({ state, event, seconds }) =>
      el("li", { title: `in ${state}: ${event === "END" ? "waits for the end of the motion" : event}, about ${seconds.toFixed(2)} s` }, state, el("small", {}, event === "END" ? "end" : event)));
    const cancel = el("button", { type: "button" }, "cancel");
    cancel.addEventListener("click", () => void travelling.cancel());
    const title = el("strong", {}, `to ${plan.goal}`, el("small", {}, `about ${plan.seconds.toFixed(1)} s`));
    host.replaceChildren(title, el("ol", {}, ...steps, el("li", { class: "goal" }, plan.goal)), cancel);
    mark();
  });
  session.state.on(mark);
}
