/**
 * Explains one tick of the watched actor: its states, the verdicts and their causes. Covers the graph while
 * it is open.
 */

import "./why.css";
import * as actors from "../../net/actors";
import type { Why } from "../../net/protocol";
import type { Session } from "../../state/session";
import { el, say } from "../../ui/dom";
import { explanation } from "./explanation";
import { Remedies, type RemedyActions } from "./remedies";

const LOOK_AROUND_TICKS = 100_000;

export class WhyPanel {
  private readonly title = el("h2");
  private readonly states = el("p", { class: "states" });
  private readonly events = el("div", { class: "events-why" });
  private readonly remedies: Remedies;
  private tick = 0;
  private requests = 0;

  constructor(
    private readonly host: HTMLElement,
    private readonly session: Session,
    private readonly actions: RemedyActions,
    private readonly goToCell: (layer: number, state: string, event: string) => void,
  ) {
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
      button("×", "close (Esc)", () => this.close()),
    );
    const notHost = el("section", { class: "why-not" });
    host.append(head, el("div", { class: "why-body" }, this.states, this.events, notHost));
    this.remedies = new Remedies(notHost, session, actions);
    host.hidden = true;
    host.tabIndex = -1;
    host.addEventListener("keydown", (press) => press.key === "Escape" && this.close());
    session.leaving.on(() => this.close());
    session.actor.on(() => this.close());
  }

  /** Opens for `tick` of the watched actor. */
  async open(tick: number): Promise<void> {
    const [actor, request] = [this.session.actor.value, ++this.requests];
    if (actor === null) return;
    this.tick = tick;
    if (this.host.hidden) this.appear();
    say(this.title, `why, in tick ${tick}`);
    this.remedies.about(Math.max(1, tick));
    const answer = await actors.why(this.session.stage, actor, tick).catch((error: Error) => error);
    if (request !== this.requests) return;
    if (answer instanceof Error) this.events.replaceChildren(el("p", {}, answer.message));
    else this.show(answer);
  }

  /** Shows the panel and gives it the focus, so that Escape closes it. */
  private appear(): void {
    this.host.hidden = false;
    this.host.focus({ preventScroll: true });
  }

  close(): void {
    this.requests++;
    this.host.hidden = true;
  }

  private show({ states, since, events, tick }: Why): void {
    const layers = this.session.cast?.layers ?? [];
    const rate = this.session.hello.value?.rate ?? 60;
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
        this.goToCell(layer, state, event),
      );
    });
    this.events.replaceChildren(...(shown.length ? shown : [none]));
    this.host.dataset["tick"] = String(tick);
  }

  /** Goes to the next or previous tick with an event or a change of state. */
  private step(by: 1 | -1): void {
    const actor = this.session.actor.value ?? -1;
    const [from, to] =
      by > 0
        ? [this.tick + 1, this.tick + LOOK_AROUND_TICKS]
        : [Math.max(0, this.tick - LOOK_AROUND_TICKS), this.tick - 1];
    const ticks = this.session.happened(actor, from, to);
    const next = by > 0 ? Math.min(...ticks) : Math.max(...ticks);
    if (!Number.isFinite(next)) return;
    this.actions.look(next);
    void this.open(next);
  }
}
