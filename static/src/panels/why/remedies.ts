/** Why not: an event that did not fire, and single changes with which it would have; each can be tried from here where that makes sense. */

import * as explain from "../../net/explain";
import type { Remedy, WhyNot } from "../../net/explained";
import type { Session } from "../../session";
import { el } from "../dom";
import { trialWords } from "./words";

/** What trying needs from the rest of the page. */
export interface Trials {
  /** Puts a text into a cell, to be kept or dropped. */
  edit(layer: number, state: string, event: string, text: string): void;
  goTo(state: string): void;
  look(tick: number): void;
}

export class Remedies {
  private readonly event = el("select", { "aria-label": "event that did not fire" });
  private readonly answer = el("div", { class: "answer", "aria-live": "polite" });
  private tick = 0;
  private asked = 0;

  constructor(
    host: HTMLElement,
    private readonly session: Session,
    private readonly trials: Trials,
  ) {
    host.append(el("h3", {}, "why not", this.event), this.answer);
    this.event.addEventListener("change", () => void this.ask());
    session.machine.on((machine) => {
      const chosen = this.event.value;
      const events = (machine?.events ?? []).filter((event) => event !== "END");
      this.event.replaceChildren(el("option", { value: "" }, "choose an event"), ...events.map((event) => el("option", { value: event }, event)));
      this.event.value = events.includes(chosen) ? chosen : "";
    });
  }

  /** The tick that is asked about; an answer about another one goes. */
  about(tick: number): void {
    this.tick = tick;
    this.answer.replaceChildren();
    if (this.event.value) void this.ask();
  }

  private async ask(): Promise<void> {
    const [actor, event, asked] = [this.session.actor.value, this.event.value, ++this.asked];
    if (actor === null || !event) return this.answer.replaceChildren();
    this.answer.replaceChildren(el("p", {}, "trying what would help…"));
    const found = await explain.whyNot(this.session.stage, actor, event, this.tick).catch((error: Error) => error);
    if (asked !== this.asked) return;
    this.answer.replaceChildren(...(found instanceof Error ? [el("p", {}, found.message)] : this.shown(found)));
  }

  private shown({ fired, reason, remedies }: WhyNot): HTMLElement[] {
    const said = el("p", { class: "reason" }, fired ? `It did fire: ${reason}` : reason);
    if (fired) return [said];
    if (!remedies.length) return [said, el("p", {}, "No single change was found that makes it fire.")];
    return [said, el("ol", { class: "remedies" }, ...remedies.map((remedy) => this.item(remedy)))];
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

  private attempt({ kind, change }: Remedy): void {
    const actor = this.session.actor.value;
    if (actor === null) return;
    if (kind === "cell") this.trials.edit(change.layer ?? 0, change.state ?? "", change.event ?? "", change.text ?? "");
    else if (kind === "state") this.trials.goTo(change.state ?? "");
    else if (kind === "moment") this.trials.look(change.tick ?? this.tick);
    else this.now(actor, kind, change);
  }

  /** What is tried in the present. */
  private now(actor: number, kind: string, { event = "", parameter = "", value = 0 }: Remedy["change"]): void {
    this.session.live();
    if (kind === "send") this.session.event("press", event);
    else if (kind === "set") void this.session.command((stage) => explain.setParameter(stage, actor, parameter, value));
  }
}
