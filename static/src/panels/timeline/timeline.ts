/** Draws the stage's history under a scrub bar; a click asks why. */

import "./timeline.css";
import { laneKey } from "../../state/history";
import type { App } from "../../view/app";
import { byId, el, onTheme, token } from "../../ui/dom";
import { laneRows } from "./laneRows";
import { Transport } from "./transport";
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
/** Between two drawings. */
const [FAST_MS, SLOW_MS] = [33, 100];
const SNAP_PIXELS = 7;
/** A pointer that moves farther scrubs; it does not click. */
const CLICK_PIXELS = 4;

class Timeline {
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
  private readonly interval_ms: number;
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
    private readonly app: App,
  ) {
    this.interval_ms = app.view.scene.quality === "low" ? SLOW_MS : FAST_MS;
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
    app.frame.on(({ now }) => this.update(now));
  }

  private ask(tick: number): void {
    this.app.inspection.why.value = tick;
  }

  private look(tick: number): void {
    this.app.playback.replaying.value = false;
    this.app.playback.look(tick);
  }

  /** On a click, shows the nearest tick with an event and asks why. */
  private released(press: PointerEvent): void {
    this.scrub.blur();
    const down = this.downAt;
    this.downAt = null;
    if (down === null || Math.abs(press.clientX - down) > CLICK_PIXELS) return;
    const { left, width } = this.canvas.getBoundingClientRect();
    const span = this.span();
    const marked = this.app.past.happened(this.app.selection.actor.value ?? -1, span.from, span.to);
    const tick = tickAt(press.clientX - left, span, width, marked, SNAP_PIXELS);
    this.look(tick);
    this.ask(tick);
  }

  private span(): Span {
    const { first, head, rate } = this.app.stage;
    return spanOf(first, head, this.all ? null : WINDOW_S * rate, this.app.playback.looking.value);
  }

  private setZoom(all: boolean): void {
    this.all = all;
    this.zoom.textContent = all ? "all" : "2 min";
    this.zoom.setAttribute("aria-label", all ? "all of the history" : "2 min: the last two minutes");
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
      font: `500 ${token("--text-xs")} ${token("--font")}`,
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
  private update(now: number): void {
    const { stage, playback, selection } = this.app;
    const { head, first, tick } = stage;
    const key = [head, first, tick, playback.looking.value, selection.actor.value].join();
    if (key === this.drawn || (now - this.lastDraw < this.interval_ms && this.drawn)) return;
    this.drawn = key;
    this.lastDraw = now;
    this.draw();
  }

  private draw(): void {
    const { app, pen } = this;
    const span = this.span();
    const ratio = window.devicePixelRatio || 1;
    const width = this.canvas.width / ratio;
    const actor = app.selection.actor.value ?? -1;
    const actions = app.past.events.actionsBetween(actor, app.stage.first, app.stage.head);
    const layers = app.selection.cast?.layers ?? [];
    const rows = laneRows(layers.length, actions.length > 0);
    this.form(layers, rows.height);
    const sheet: LaneCanvas = { pen, span, width, ink: this.ink };
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, width, rows.height);
    rows.layers.forEach((lane, layer) => {
      const runs = app.past.runs.between(laneKey(actor, layer), span.from, span.to);
      drawRuns(
        sheet,
        app.playback.looking.value === null ? runs : upTo(runs, app.stage.head),
        lane,
        (state) => app.selection.stateIndex(actor, state, layer),
      );
      drawBlends(sheet, app.past.events.blendsBetween(actor, layer, span.from, span.to), lane);
      drawMarks(sheet, app.past.events.marksBetween(actor, span.from, span.to, layer), lane);
    });
    if (rows.actions !== null)
      drawActions(
        sheet,
        actions.filter(({ tick }) => tick >= span.from),
        rows.actions,
      );
    const shown = app.playback.looking.value ?? app.stage.tick;
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

export function timelinePanel(_host: HTMLElement, app: App): void {
  const { tools } = new Transport(byId("transport"), app);
  new Timeline(byId("lanes"), tools, app);
}
