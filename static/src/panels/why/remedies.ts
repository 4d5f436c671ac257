/** Asks whynot: shows single changes with which an event fires, with buttons to try them. */

import * as actors from "../../net/actors";
import type { Remedy, WhyNot } from "../../net/protocol";
import { reasonOf } from "../../net/reason";
import type { App } from "../../view/app";
import { el } from "../../ui/dom";
import { trialWords } from "./words";

export class Remedies {
  private readonly event = el("select", { "aria-label": "event that did not fire" });
  private readonly answer = el("div", { class: "answer", "aria-live": "polite" });
  private tick = 0;
  private requests = 0;

  constructor(
    host: HTMLElement,
    private readonly app: App,
  ) {
    host.append(el("h3", {}, "why not", this.event), this.answer);
    this.event.addEventListener("change", () => void this.ask());
    app.machine.info.subscribe((machine) => {
      const chosen = this.event.value;
      const events = (machine?.events ?? []).filter((event) => event !== "END");
      this.event.replaceChildren(
        el("option", { value: "" }, "choose an event"),
        ...events.map((event) => el("option", { value: event }, event)),
      );
      this.event.value = events.includes(chosen) ? chosen : "";
    });
  }

  /** Sets the tick and asks again, if an event is chosen; `lost`: the event that was dropped in the tick. */
  about(tick: number, lost?: string): void {
    this.tick = tick;
    this.event.value = lost ?? this.event.value;
    this.answer.replaceChildren();
    if (this.event.value) void this.ask();
  }

  private async ask(): Promise<void> {
    const [actor, event, request] = [this.app.selection.actor.value, this.event.value, ++this.requests];
    if (actor === null || !event) {
      this.answer.replaceChildren();
      return;
    }
    this.answer.replaceChildren(el("p", {}, "trying changes…"));
    const found = await actors.whyNot(this.app.stage.id, actor, event, this.tick).catch(reasonOf);
    if (request !== this.requests) return;
    this.answer.replaceChildren(...(typeof found === "string" ? [el("p", {}, found)] : this.shown(found)));
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
    const actor = this.app.selection.actor.value;
    if (actor === null) return;
    const { inspection, playback, travel } = this.app;
    if (change.kind === "cell") inspection.cells.emit(change);
    else if (change.kind === "state") void travel.go(change.state);
    else if (change.kind === "moment") playback.look(change.tick);
    else this.now(actor, change);
  }

  /** Tries a remedy in the present. */
  private now(actor: number, change: Remedy["change"]): void {
    this.app.playback.live();
    if (change.kind === "send") this.app.session.event("press", change.event);
    else if (change.kind === "set")
      void this.app.session.command((stage) =>
        actors.setParameter(stage, actor, change.parameter, change.value),
      );
  }
}
