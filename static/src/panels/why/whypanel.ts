/** The why-panel: what happened to the watched actor in one tick, and why; it lies over the graph while it is open. */

import * as explain from "../../net/explain";
import type { Why } from "../../net/explained";
import type { Session } from "../../session";
import { el, say } from "../dom";
import { explanation } from "./explanation";
import { Remedies, type Trials } from "./remedies";

const LOOK_AROUND_TICKS = 100_000;

export class WhyPanel {
  private readonly title = el("h2");
  private readonly states = el("p", { class: "states" });
  private readonly events = el("div", { class: "events-why" });
  private readonly remedies: Remedies;
  private tick = 0;
  private asked = 0;

  constructor(
    private readonly host: HTMLElement,
    private readonly session: Session,
    private readonly trials: Trials,
    private readonly goToCell: (layer: number, state: string, event: string) => void,
  ) {
    const button = (label: string, words: string, act: () => void): HTMLButtonElement => {
      const made = el("button", { type: "button", class: "plain square", "aria-label": words, title: words }, label);
      made.addEventListener("click", act);
      return made;
    };
    const head = el("header", {}, this.title, button("‹", "what happened before", () => this.step(-1)), button("›", "what happened next", () => this.step(1)), button("×", "close (Esc)", () => this.close()));
    const notHost = el("section", { class: "why-not" });
    host.append(head, el("div", { class: "why-body" }, this.states, this.events, notHost));
    this.remedies = new Remedies(notHost, session, trials);
    host.hidden = true;
    host.tabIndex = -1;
    host.addEventListener("keydown", (press) => press.key === "Escape" && this.close());
    session.leaving.on(() => this.close());
    session.actor.on(() => this.close());
  }

  /** Opens for `tick` of the watched actor. */
  async open(tick: number): Promise<void> {
    const [actor, asked] = [this.session.actor.value, ++this.asked];
    if (actor === null) return;
    this.tick = tick;
    if (this.host.hidden) this.appear();
    say(this.title, `why, in tick ${tick}`);
    this.remedies.about(Math.max(1, tick));
    const found = await explain.why(this.session.stage, actor, tick).catch((error: Error) => error);
    if (asked !== this.asked) return;
    if (found instanceof Error) this.events.replaceChildren(el("p", {}, found.message));
    else this.show(found);
  }

  /** With the focus, so that Escape closes it again. */
  private appear(): void {
    this.host.hidden = false;
    this.host.focus({ preventScroll: true });
  }

  close(): void {
    this.asked++;
    this.host.hidden = true;
  }

  private show({ states, since, events, tick }: Why): void {
    const layers = this.session.cast?.layers ?? [];
    const rate = this.session.hello.value?.rate ?? 60;
    const several = layers.length > 1;
    say(this.states, states.map((state, i) => `${several ? `${layers[i] ?? i}: ` : ""}${state} for ${((tick - since[i]!) / rate).toFixed(2)} s`).join(" · "));
    const none = el("p", { class: "nothing" }, "Nothing happened to it in this tick.");
    const shown = events.map((one) => explanation(one, several ? (layers[one.layer] ?? "") : "", (state, event) => this.goToCell(one.layer, state, event)));
    this.events.replaceChildren(...(shown.length ? shown : [none]));
    this.host.dataset["tick"] = String(tick);
  }

  /** To the tick before or after this one in which something is known to have happened. */
  private step(by: 1 | -1): void {
    const actor = this.session.actor.value ?? -1;
    const [from, to] = by > 0 ? [this.tick + 1, this.tick + LOOK_AROUND_TICKS] : [Math.max(0, this.tick - LOOK_AROUND_TICKS), this.tick - 1];
    const ticks = this.session.happened(actor, from, to);
    const next = by > 0 ? Math.min(...ticks) : Math.max(...ticks);
    if (!Number.isFinite(next)) return;
    this.trials.look(next);
    void this.open(next);
  }
}
