/**
 * Explains one tick of the watched actor: its states, the verdicts and their causes. Covers the graph while
 * it is open.
 */

import "./why.css";
import * as actors from "../../net/actors";
import type { Why } from "../../net/protocol";
import { reasonOf } from "../../net/reason";
import type { App } from "../../view/app";
import { el, say } from "../../ui/dom";
import { explanation } from "./explanation";
import { Remedies } from "./remedies";

const LOOK_AROUND_TICKS = 100_000;

class WhyPanel {
  private readonly title = el("h2");
  private readonly states = el("p", { class: "states" });
  private readonly events = el("div", { class: "events-why" });
  private readonly remedies: Remedies;
  private tick = 0;
  private requests = 0;

  constructor(
    private readonly host: HTMLElement,
    private readonly app: App,
  ) {
    const close = (): void => {
      app.inspection.why.value = null;
    };
    const button = (label: string, words: string, act: () => void): HTMLButtonElement => {
      const made = el(
        "button",
        { type: "button", class: "plain square", "aria-label": words, title: words },
        label,
      );
      made.addEventListener("click", act);
      return made;
    };
    const head = el(
      "header",
      {},
      this.title,
      button("‹", "what happened before", () => this.step(-1)),
      button("›", "what happened next", () => this.step(1)),
      button("×", "close (Esc)", close),
    );
    const notHost = el("section", { class: "why-not" });
    host.append(head, el("div", { class: "why-body" }, this.states, this.events, notHost));
    this.remedies = new Remedies(notHost, app);
    host.hidden = true;
    host.tabIndex = -1;
    host.addEventListener("keydown", (press) => press.key === "Escape" && close());
    app.session.leaving.on(close);
    app.selection.actor.subscribe(close);
    app.inspection.why.subscribe((tick) => {
      if (tick === null) this.close();
      else void this.open(tick);
    });
  }

  /** Opens for `tick` of the watched actor. */
  private async open(tick: number): Promise<void> {
    const [actor, request] = [this.app.selection.actor.value, ++this.requests];
    if (actor === null) return;
    this.tick = tick;
    if (this.host.hidden) this.appear();
    say(this.title, `why, in tick ${tick}`);
    const answer = await actors.why(this.app.stage.id, actor, tick).catch(reasonOf);
    if (request !== this.requests) return;
    const lost =
      typeof answer === "string" ? null : answer.events.find(({ verdict }) => verdict === "dropped");
    this.remedies.about(Math.max(1, tick), lost?.event);
    if (typeof answer === "string") this.events.replaceChildren(el("p", {}, answer));
    else this.show(answer);
  }

  /** Shows the panel and gives it the focus, so that Escape closes it. */
  private appear(): void {
    this.host.hidden = false;
    this.host.focus({ preventScroll: true });
  }

  private close(): void {
    this.requests++;
    this.host.hidden = true;
  }

  private show({ states, since, events, tick }: Why): void {
    const layers = this.app.selection.cast?.layers ?? [];
    const rate = this.app.stage.hello.value?.rate ?? 60;
    const hasLayers = layers.length > 1;
    const line = (state: string, i: number): string => {
      const layer = hasLayers ? `${layers[i] ?? i}: ` : "";
      return `${layer}${state} for ${((tick - since[i]!) / rate).toFixed(2)} s`;
    };
    say(this.states, states.map(line).join(" · "));
    const none = el("p", { class: "nothing" }, "Nothing happens to this actor in this tick.");
    const shown = events.map((explained) => {
      const { layer } = explained;
      return explanation(explained, hasLayers ? (layers[layer] ?? "") : "", (state, event) =>
        this.app.inspection.cells.emit({ layer, state, event, text: null }),
      );
    });
    this.events.replaceChildren(...(shown.length ? shown : [none]));
    this.host.dataset["tick"] = String(tick);
  }

  /** Goes to the next or previous tick with an event or a change of state. */
  private step(by: 1 | -1): void {
    const actor = this.app.selection.actor.value ?? -1;
    const [from, to] =
      by > 0
        ? [this.tick + 1, this.tick + LOOK_AROUND_TICKS]
        : [Math.max(0, this.tick - LOOK_AROUND_TICKS), this.tick - 1];
    const ticks = this.app.past.happened(actor, from, to);
    const next = by > 0 ? Math.min(...ticks) : Math.max(...ticks);
    if (!Number.isFinite(next)) return;
    this.app.playback.look(next);
    this.app.inspection.why.value = next;
  }
}

export function whyPanel(host: HTMLElement, app: App): void {
  new WhyPanel(host, app);
}
