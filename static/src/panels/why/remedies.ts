/** Asks whynot: shows single changes with which an event fires, with buttons to try them. */

import { effect, signal } from "@preact/signals-core";
import { html, nothing, type TemplateResult } from "lit-html";
import { live } from "lit-html/directives/live.js";
import * as actors from "../../net/actors";
import type { Remedy, WhyNot } from "../../net/protocol";
import { reasonOf } from "../../net/reason";
import type { App } from "../../view/app";
import { trialWords } from "./words";

type Part = TemplateResult | typeof nothing;

const said = (words: string): Part => (words ? html`<p .textContent=${words}></p>` : nothing);

export class Remedies {
  private readonly event = signal("");
  private readonly answer = signal<Part>(nothing);
  private tick = 0;
  private requests = 0;

  constructor(private readonly app: App) {
    effect(() => {
      if (!this.events().includes(this.event.value)) this.event.value = "";
    });
  }

  private events(): string[] {
    return this.app.machine.info.value?.events.filter((event) => event !== "END") ?? [];
  }

  /** Sets the tick and asks again, if an event is chosen; `lost`: the event that was dropped in the tick. */
  about(tick: number, lost?: string): void {
    this.tick = tick;
    this.choose(lost ?? this.event.value);
  }

  private choose(event: string): void {
    this.event.value = event;
    void this.ask();
  }

  private async ask(): Promise<void> {
    const [actor, event, request] = [this.app.selection.actor.value, this.event.value, ++this.requests];
    const isAsked = actor !== null && event !== "";
    this.answer.value = said(isAsked ? "trying changes…" : "");
    if (!isAsked) return;
    const found = await actors.whyNot(this.app.stage.id, actor, event, this.tick).catch(reasonOf);
    if (request !== this.requests) return;
    this.answer.value = typeof found === "string" ? said(found) : this.shown(found);
  }

  part(): TemplateResult {
    const choose = ({ target }: Event): void => this.choose((target as HTMLSelectElement).value);
    const option = (event: string): TemplateResult =>
      html`<option
        value=${event}
        .selected=${live(event === this.event.value)}
        .text=${event || "choose an event"}
      ></option>`;
    return html`<section class="why-not">
      <h3>
        why not
        <select aria-label="event that did not fire" @change=${choose}>
          ${["", ...this.events()].map(option)}
        </select>
      </h3>
      <div class="answer" aria-live="polite">${this.answer.value}</div>
    </section>`;
  }

  private shown({ fired, reason, remedies, cut }: WhyNot): TemplateResult {
    const items = remedies.map((remedy) => this.item(remedy));
    const end = cut || (items.length ? "" : "No single change makes it fire.");
    return html`<p class="reason" .textContent=${fired ? `It fires: ${reason}` : reason}></p>
      ${
        items.length
          ? html`<ol class="remedies">
              ${items}
            </ol>`
          : nothing
      }
      ${said(fired ? "" : end)}`;
  }

  private item(remedy: Remedy): TemplateResult {
    const words = trialWords(remedy.kind);
    const attempt = (): void => this.attempt(remedy);
    return html`<li data-kind=${remedy.kind}>
      <span .textContent=${remedy.text}></span>
      ${words ? html`<button type="button" @click=${attempt}>${words}</button>` : nothing}
    </li>`;
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
