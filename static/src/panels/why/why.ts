/**
 * Explains one tick of the watched actor: its states, the verdicts and their causes. Covers the graph while
 * it is open.
 */

import "./why.css";
import { signal } from "@preact/signals-core";
import { html, type TemplateResult } from "lit-html";
import * as actors from "../../net/actors";
import { Latest } from "../../net/latest";
import type { Why } from "../../net/protocol";
import { reasonOf } from "../../net/reason";
import type { App } from "../../view/app";
import { draw } from "../../ui/draw";
import { explanation } from "./explanation";
import { Remedies } from "./remedies";

const LOOK_AROUND_TICKS = 100_000;
/** How many ticks are explained in a second while the playhead is dragged, or the past is replayed. */
const MOST_PER_SECOND = 4;

class WhyPanel {
  private readonly tick = signal(0);
  private readonly states = signal("");
  private readonly events = signal<readonly TemplateResult[]>([]);
  private readonly remedies: Remedies;
  private readonly asking = new Latest<number>((tick) => void this.ask(tick), MOST_PER_SECOND);
  private requests = 0;

  constructor(
    private readonly host: HTMLElement,
    private readonly app: App,
  ) {
    this.remedies = new Remedies(app);
    host.hidden = true;
    host.tabIndex = -1;
    host.addEventListener("keydown", (press) => press.key === "Escape" && this.leave());
    draw(host, () => this.content());
    app.session.leaving.on(() => this.leave());
    app.selection.actor.subscribe(() => this.leave());
    app.inspection.why.subscribe((tick) => {
      if (tick === null) this.close();
      else this.open(tick);
    });
    app.playback.looking.subscribe((tick) => this.follow(tick));
  }

  private leave(): void {
    this.app.inspection.why.value = null;
  }

  private content(): TemplateResult {
    const button = (label: string, words: string, act: () => void): TemplateResult =>
      html`<button type="button" class="plain square" aria-label=${words} title=${words} @click=${act}>
        ${label}
      </button>`;
    return html`<header>
        <h2 .textContent=${`why, in tick ${this.tick.value}`}></h2>
        ${button("‹", "what happened before", () => this.step(-1))}
        ${button("›", "what happened next", () => this.step(1))}
        ${button("×", "close (Esc)", () => this.leave())}
      </header>
      <div class="why-body">
        <p class="states" .textContent=${this.states.value}></p>
        <div class="events-why">${this.events.value}</div>
        ${this.remedies.part()}
      </div>`;
  }

  /** Opens for `tick` of the watched actor. */
  private open(tick: number): void {
    if (this.app.selection.actor.value === null) return;
    this.tick.value = tick;
    if (this.host.hidden) this.appear();
    this.asking.put(tick);
  }

  /** Explains `tick`, which the page shows of the past; null, the present, changes nothing. */
  private follow(tick: number | null): void {
    const { why } = this.app.inspection;
    if (tick !== null && why.value !== null) why.value = tick;
  }

  private async ask(tick: number): Promise<void> {
    const [actor, request] = [this.app.selection.actor.value, ++this.requests];
    if (actor === null || tick !== this.app.inspection.why.value) return; // closed meanwhile
    const answer = await actors.why(this.app.stage.id, actor, tick).catch(reasonOf);
    if (request !== this.requests) return;
    const lost =
      typeof answer === "string" ? null : answer.events.find(({ verdict }) => verdict === "dropped");
    this.remedies.about(Math.max(1, tick), lost?.event);
    if (typeof answer === "string") {
      this.states.value = "";
      this.events.value = [html`<p .textContent=${answer}></p>`];
    } else {
      this.show(answer);
    }
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
    this.states.value = states.map(line).join(" · ");
    const none = html`<p class="nothing">Nothing happens to this actor in this tick.</p>`;
    const shown = events.map((explained) => {
      const { layer } = explained;
      return explanation(explained, hasLayers ? (layers[layer] ?? "") : "", (state, event) =>
        this.app.inspection.cells.emit({ layer, state, event, text: null }),
      );
    });
    this.events.value = shown.length ? shown : [none];
    this.host.dataset["tick"] = String(tick);
  }

  /** Goes to the next or previous tick with an event or a change of state. */
  private step(by: 1 | -1): void {
    const actor = this.app.selection.actor.value ?? -1;
    const at = this.tick.value;
    const [from, to] =
      by > 0 ? [at + 1, at + LOOK_AROUND_TICKS] : [Math.max(0, at - LOOK_AROUND_TICKS), at - 1];
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
