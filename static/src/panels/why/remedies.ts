/** Asks whynot: shows single changes with which an event fires, with buttons to try them. */

import * as actors from "../../net/actors";
import type { Remedy, WhyNot } from "../../net/protocol";
import type { Session } from "../../state/session";
import { el } from "../../ui/dom";
import { trialWords } from "./words";

/** Tries remedies in other parts of the page. */
export interface RemedyActions {
  /** Types a text into a cell; you keep or drop it. */
  edit(layer: number, state: string, event: string, text: string): void;
  goTo(state: string): void;
  look(tick: number): void;
}

export class Remedies {
  private readonly event = el("select", { "aria-label": "event that did not fire" });
  private readonly answer = el("div", { class: "answer", "aria-live": "polite" });
  private tick = 0;
  private requests = 0;

  constructor(
    host: HTMLElement,
    private readonly session: Session,
    private readonly actions: RemedyActions,
  ) {
    host.append(el("h3", {}, "why not", this.event), this.answer);
    this.event.addEventListener("change", () => void this.ask());
    session.machine.on((machine) => {
      const chosen = this.event.value;
      const events = (machine?.events ?? []).filter((event) => event !== "END");
      this.event.replaceChildren(
        el("option", { value: "" }, "choose an event"),
        ...events.map((event) => el("option", { value: event }, event)),
      );
      this.event.value = events.includes(chosen) ? chosen : "";
    });
  }

  /** Sets the tick and asks again, if an event is chosen. */
  about(tick: number): void {
    this.tick = tick;
    this.answer.replaceChildren();
    if (this.event.value) void this.ask();
  }

  private async ask(): Promise<void> {
    const [actor, event, request] = [this.session.actor.value, this.event.value, ++this.requests];
    if (actor === null || !event) return this.answer.replaceChildren();
    this.answer.replaceChildren(el("p", {}, "trying changes…"));
    const found = await actors
      .whyNot(this.session.stage, actor, event, this.tick)
      .catch((error: Error) => error);
    if (request !== this.requests) return;
    this.answer.replaceChildren(
      ...(found instanceof Error ? [el("p", {}, found.message)] : this.shown(found)),
    );
  }

  private shown({ fired, reason, remedies, cut }: WhyNot): HTMLElement[] {
    const answer = el("p", { class: "reason" }, fired ? `It fires: ${reason}` : reason);
    if (fired) return [answer];
    const items = remedies.map((remedy) => this.item(remedy));
    const parts = [answer, ...(items.length ? [el("ol", { class: "remedies" }, ...items)] : [])];
    if (cut) return [...parts, el("p", {}, cut)];
    return items.length ? parts : [...parts, el("p", {}, "No single change makes it fire.")];
  }

  private item(remedy: Remedy): HTMLElement {
    const words = trialWords(remedy.kind);
    const item = el("li", { "data-kind": remedy.kind }, el("span", {}, remedy.text));
    if (!words) return item;
    const button = el("button", { type: "button" }, words);
    button.addEventListener("click", () => this.attempt(remedy));
    item.append(button);
    return item;
  }

  private attempt({ change }: Remedy): void {
    const actor = this.session.actor.value;
    if (actor === null) return;
    if (change.kind === "cell") this.actions.edit(change.layer, change.state, change.event, change.text);
    else if (change.kind === "state") this.actions.goTo(change.state);
    else if (change.kind === "moment") this.actions.look(change.tick);
    else this.now(actor, change);
  }

  /** Tries a remedy in the present. */
  private now(actor: number, change: Remedy["change"]): void {
    this.session.live();
    if (change.kind === "send") this.session.event("press", change.event);
    else if (change.kind === "set")
      void this.session.command((stage) => actors.setParameter(stage, actor, change.parameter, change.value));
  }
}
