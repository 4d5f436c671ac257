/** Draws the stage's history under a scrub bar; a click asks why. */

import "./timeline.css";
import { laneKey } from "../../state/history";
import type { Player } from "../../state/player";
import type { Session } from "../../state/session";
import { el, onTheme, token } from "../../ui/dom";
import { laneRows } from "./laneRows";
import {
  type LaneInk,
  type LaneCanvas,
  type Span,
  drawActions,
  drawBlends,
  drawHead,
  drawMarks,
  drawRuns,
  place,
  spanOf,
  tickAt,
  upTo,
} from "./lanes";

const WINDOW_S = 120;
const SNAP_PIXELS = 7;
/** A pointer that moves farther scrubs; it does not click. */
const CLICK_PIXELS = 4;

export class Timeline {
  private readonly canvas = el("canvas", { "aria-hidden": true });
  private readonly names = el("div", { class: "lane-names", "aria-hidden": true });
  private readonly scrub = el("input", {
    type: "range",
    class: "scrub",
    "aria-label": "history: tick that is shown",
    min: 0,
    max: 1,
    step: 1,
    value: 0,
  });
  private readonly zoom = el("button", {
    type: "button",
    class: "plain zoom",
    title: "how much of the history is shown",
  });
  private readonly pen: CanvasRenderingContext2D;
  private ink!: LaneInk;
  private all = false;
  private drawn = "";
  private lastDraw = 0;
  private shape = "";
  private downAt: number | null = null;

  constructor(
    private readonly host: HTMLElement,
    tools: HTMLElement,
    private readonly session: Session,
    private readonly player: Player,
    private readonly interval_ms: number,
    private readonly ask: (tick: number) => void,
  ) {
    host.append(this.names, this.canvas, this.scrub);
    tools.append(this.zoom);
    this.pen = this.canvas.getContext("2d")!;
    this.scrub.addEventListener("input", () => this.look(Number(this.scrub.value)));
    this.scrub.addEventListener("pointerdown", (press) => (this.downAt = press.clientX));
    this.scrub.addEventListener("pointerup", (press) => this.released(press));
    this.scrub.addEventListener(
      "keydown",
      (press) => press.key === "Enter" && this.ask(Number(this.scrub.value)),
    );
    this.scrub.title = "drag: go through the past; click: why?";
    this.zoom.addEventListener("click", () => this.setZoom(!this.all));
    this.setZoom(false);
    new ResizeObserver(() => this.resize()).observe(host);
    onTheme(() => this.takeTheme());
  }

  private look(tick: number): void {
    this.player.replaying.set(false);
    this.session.look(tick);
  }

  /** On a click, shows the nearest tick with an event and asks why. */
  private released(press: PointerEvent): void {
    this.scrub.blur();
    const down = this.downAt;
    this.downAt = null;
    if (down === null || Math.abs(press.clientX - down) > CLICK_PIXELS) return;
    const { left, width } = this.canvas.getBoundingClientRect();
    const span = this.span();
    const marked = this.session.happened(this.session.actor.value ?? -1, span.from, span.to);
    const tick = tickAt(press.clientX - left, span, width, marked, SNAP_PIXELS);
    this.look(tick);
    this.ask(tick);
  }

  private span(): Span {
    const { first, head, looking, hello } = this.session;
    return spanOf(first, head, this.all ? null : WINDOW_S * (hello.value?.rate ?? 60), looking.value);
  }

  private setZoom(all: boolean): void {
    this.all = all;
    this.zoom.textContent = all ? "all" : "2 min";
    this.zoom.setAttribute("aria-label", all ? "shows all of the history" : "shows the last two minutes");
    this.drawn = "";
  }

  private takeTheme(): void {
    const dark = window.matchMedia("(prefers-color-scheme: dark)").matches;
    this.ink = {
      dark,
      text: token("--ink"),
      quiet: token("--ink-2"),
      accent: token("--accent"),
      empty: token("--raise"),
      font: `500 11px ${token("--font")}`,
    };
    this.drawn = "";
  }

  private resize(): void {
    const { width, height } = this.canvas.getBoundingClientRect();
    const ratio = window.devicePixelRatio || 1;
    Object.assign(this.canvas, { width: Math.round(width * ratio), height: Math.round(height * ratio) });
    this.drawn = "";
  }

  /** Draws if something changed, at most once per interval. */
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
    const span = this.span();
    const ratio = window.devicePixelRatio || 1;
    const width = this.canvas.width / ratio;
    const actor = session.actor.value ?? -1;
    const actions = session.eventLog.actionsBetween(actor, session.first, session.head);
    const layers = session.cast?.layers ?? [];
    const rows = laneRows(layers.length, actions.length > 0);
    this.form(layers, rows.height);
    const sheet: LaneCanvas = { pen, span, width, ink: this.ink };
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, width, rows.height);
    rows.layers.forEach((lane, layer) => {
      const runs = session.history.between(laneKey(actor, layer), span.from, span.to);
      drawRuns(sheet, session.looking.value === null ? runs : upTo(runs, session.head), lane, (state) =>
        session.stateIndex(actor, state, layer),
      );
      drawBlends(sheet, session.eventLog.blendsBetween(actor, layer, span.from, span.to), lane);
      drawMarks(sheet, session.eventLog.marksBetween(actor, span.from, span.to, layer), lane);
    });
    if (rows.actions !== null)
      drawActions(
        sheet,
        actions.filter(({ tick }) => tick >= span.from),
        rows.actions,
      );
    const shown = session.looking.value ?? session.tick;
    drawHead(sheet, Math.min(width - 2, Math.max(2, place(shown, span, width))), rows.height);
    this.setScrub(span.from, span.to, shown);
  }

  /** Sets the lanes' height; with several layers, writes their names beside the lanes. */
  private form(layers: readonly string[], height: number): void {
    const shape = `${layers.join()} ${height}`;
    if (shape === this.shape) return;
    this.shape = shape;
    this.host.style.height = `${height}px`;
    const rows = laneRows(layers.length, false).layers;
    const named = layers.length > 1 ? layers : [];
    const labels = named.map((name) => el("span", { title: name }, name));
    labels.forEach((label, i) => (label.style.top = `${rows[i]!.state}px`));
    this.names.replaceChildren(...labels);
    this.host.classList.toggle("named", named.length > 0);
  }

  private setScrub(from: number, to: number, shown: number): void {
    Object.assign(this.scrub, { min: String(from), max: String(to) });
    this.scrub.value = String(shown);
    this.scrub.setAttribute("aria-valuetext", `tick ${shown} of ${to}`);
  }
}
