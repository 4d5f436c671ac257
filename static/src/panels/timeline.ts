/** The scrub bar over the stage's history, with what happened in it. */

import type { Player } from "../player";
import type { Session } from "../session";
import { el, onTheme, token } from "./dom";
import { type LaneInk, drawHead, drawMarks, drawRuns, place, spanOf } from "./lanes";

const WINDOW_S = 120;

export class Timeline {
  private readonly canvas = el("canvas", { "aria-hidden": true });
  private readonly scrub = el("input", { type: "range", class: "scrub", "aria-label": "history: tick that is shown", min: 0, max: 1, step: 1, value: 0 });
  private readonly zoom = el("button", { type: "button", class: "plain zoom", title: "how much of the history is shown" });
  private readonly pen: CanvasRenderingContext2D;
  private ink!: LaneInk;
  private all = false;
  private drawn = "";
  private lastDraw = 0;

  constructor(
    host: HTMLElement,
    tools: HTMLElement,
    private readonly session: Session,
    player: Player,
    private readonly interval_ms: number,
  ) {
    host.append(this.canvas, this.scrub);
    tools.append(this.zoom);
    this.pen = this.canvas.getContext("2d")!;
    this.scrub.addEventListener("input", () => {
      player.replaying.set(false);
      session.look(Number(this.scrub.value));
    });
    this.scrub.addEventListener("pointerup", () => this.scrub.blur());
    this.zoom.addEventListener("click", () => this.setZoom(!this.all));
    this.setZoom(false);
    new ResizeObserver(() => this.resize()).observe(host);
    onTheme(() => this.takeTheme());
  }

  private setZoom(all: boolean): void {
    this.all = all;
    this.zoom.textContent = all ? "all" : "2 min";
    this.zoom.setAttribute("aria-label", all ? "shows all of the history" : "shows the last two minutes");
    this.drawn = "";
  }

  private takeTheme(): void {
    const dark = window.matchMedia("(prefers-color-scheme: dark)").matches;
    this.ink = { dark, text: token("--ink"), quiet: token("--ink-2"), accent: token("--accent"), empty: token("--raise"), font: `500 11px ${token("--font")}` };
    this.drawn = "";
  }

  private resize(): void {
    const { width, height } = this.canvas.getBoundingClientRect();
    const ratio = window.devicePixelRatio || 1;
    Object.assign(this.canvas, { width: Math.round(width * ratio), height: Math.round(height * ratio) });
    this.drawn = "";
  }

  /** Draws if something changed, and not more often than is useful. */
  update(now: number): void {
    const { head, first, tick, looking, actor } = this.session;
    const key = [head, first, tick, looking.value, actor.value].join();
    if (key === this.drawn || (now - this.lastDraw < this.interval_ms && this.drawn)) return;
    this.drawn = key;
    this.lastDraw = now;
    this.draw();
  }

  private draw(): void {
    const { session, pen } = this;
    const rate = session.hello.value?.rate ?? 60;
    const span = spanOf(session.first, session.head, this.all ? null : WINDOW_S * rate, session.looking.value);
    const ratio = window.devicePixelRatio || 1;
    const [width, height] = [this.canvas.width / ratio, this.canvas.height / ratio];
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, width, height);
    const actor = session.actor.value ?? -1;
    drawRuns(pen, session.history.between(actor, span.from, span.to), span, width, this.ink, (state) => session.stateName(state));
    drawMarks(pen, session.history.marksBetween(actor, span.from, span.to), span, width, this.ink);
    const shown = session.looking.value ?? session.tick;
    drawHead(pen, Math.min(width - 2, Math.max(2, place(shown, span, width))), height, this.ink);
    this.setScrub(span.from, span.to, shown);
  }

  private setScrub(from: number, to: number, shown: number): void {
    Object.assign(this.scrub, { min: String(from), max: String(to) });
    this.scrub.value = String(shown);
    this.scrub.setAttribute("aria-valuetext", `tick ${shown} of ${to}`);
  }
}
