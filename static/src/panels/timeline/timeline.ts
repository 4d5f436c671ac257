/** Draws the stage's history under a scrub bar; a click asks why, and a span can be selected. */

import "./timeline.css";
import { laneKey } from "../../state/history";
import type { Span } from "../../state/timelineWindow";
import type { App } from "../../view/app";
import { byId, el, onTheme, token } from "../../ui/dom";
import { LaneGestures } from "./gestures";
import { type LaneRows, laneRows, type LayerRows, layersOf } from "./laneRows";
import { drawRuler, rulerMarks } from "./ruler";
import { spanBar } from "./spanBar";
import { Transport } from "./transport";
import { windowControls } from "./windowControls";
import {
  type LaneInk,
  type LaneCanvas,
  drawActions,
  drawBlends,
  drawHead,
  drawMarks,
  drawRuns,
  drawSelection,
  place,
  tickAt,
  upTo,
} from "./lanes";

/** Between two drawings. */
const [FAST_MS, SLOW_MS] = [33, 100];
const SNAP_PIXELS = 7;
/** A lane's name begins above it by so many pixels. */
const NAME_ABOVE = 3;
/** The least height of a lane whose name a finger touches. */
const FINGER = 44;
const TOUCH = window.matchMedia("(pointer: coarse)");
/** A pointer that moves farther scrubs; it does not click. */
const CLICK_PIXELS = 4;

class Timeline {
  private readonly canvas = el("canvas", { "aria-hidden": true });
  private readonly names = el("div", { class: "lane-names", role: "group", "aria-label": "lanes" });
  private readonly scrub = el("input", {
    type: "range",
    class: "scrub",
    "aria-label": "history: tick that is shown",
    min: 0,
    max: 1,
    step: 1,
    value: 0,
  });
  private readonly interval_ms: number;
  private readonly pen: CanvasRenderingContext2D;
  private readonly gestures: LaneGestures;
  private ink!: LaneInk;
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
    const { selecting } = windowControls(tools, app);
    this.pen = this.canvas.getContext("2d")!;
    this.scrub.addEventListener("input", () => this.scrubbed());
    this.scrub.addEventListener("pointerdown", (press) => (this.downAt = press.clientX));
    this.scrub.addEventListener("pointerup", (press) => this.released(press));
    this.scrub.addEventListener(
      "keydown",
      (press) => press.key === "Enter" && this.ask(Number(this.scrub.value)),
    );
    this.scrub.title = "drag: go through the past; click: why?; shift and drag: select a span; wheel: zoom";
    // Added after the listeners above, so that those still know that this drag selects, and ask no why.
    this.gestures = new LaneGestures(host, this.scrub, app.timeline, selecting);
    new ResizeObserver(() => this.resize()).observe(host);
    onTheme(() => this.takeTheme());
    app.frame.on(({ now }) => this.update(now));
  }

  private ask(tick: number): void {
    this.app.inspection.why.value = tick;
  }

  private scrubbed(): void {
    if (!this.gestures.busy) this.look(Number(this.scrub.value));
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
    if (this.gestures.busy || down === null || Math.abs(press.clientX - down) > CLICK_PIXELS) return;
    const { left, width } = this.canvas.getBoundingClientRect();
    const { span } = this.app.timeline;
    const marked = this.app.past.happened(this.app.selection.actor.value ?? -1, span.from, span.to);
    const tick = tickAt(press.clientX - left, span, width, marked, SNAP_PIXELS);
    this.look(tick);
    this.ask(tick);
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
    const { stage, past, playback, selection, timeline } = this.app;
    const { head, first, tick } = stage;
    const { span, selected, kept, folded, filter } = timeline;
    const shown = [span, selected.value, kept.value, [...folded.value], filter.value];
    const at = [head, first, tick, playback.looking.value, selection.actor.value];
    const key = JSON.stringify([at, past.learned, shown]);
    if (key === this.drawn || (now - this.lastDraw < this.interval_ms && this.drawn)) return;
    this.drawn = key;
    this.lastDraw = now;
    this.draw();
  }

  private draw(): void {
    const { app, pen } = this;
    const { span, folded, selected, kept } = app.timeline;
    const ratio = window.devicePixelRatio || 1;
    const width = this.canvas.width / ratio;
    const actor = app.selection.actor.value ?? -1;
    const actions = this.wanted(app.past.events.actionsBetween(actor, app.stage.first, app.stage.head));
    const layers = layersOf(app.selection.cast);
    const isFolded = layers.map((name) => folded.value.has(name));
    const isTouched = layers.length > 1 && TOUCH.matches;
    const rows = laneRows(isFolded, actions.length > 0, isTouched ? FINGER : 0);
    this.form(layers, rows);
    const sheet: LaneCanvas = { pen, span, width, ink: this.ink };
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, width, rows.height);
    drawRuler(sheet, rulerMarks(span, app.stage.rate, width));
    rows.layers.forEach((lane, layer) => this.drawLayer(sheet, lane, actor, layer, isFolded[layer]!));
    if (rows.actions !== null) drawActions(sheet, within(actions, span), rows.actions);
    if (kept.value) drawSelection(sheet, kept.value, rows.height, this.ink.quiet);
    if (selected.value) drawSelection(sheet, selected.value, rows.height, this.ink.accent);
    const shown = app.playback.looking.value ?? app.stage.tick;
    drawHead(sheet, Math.min(width - 2, Math.max(2, place(shown, span, width))), rows.height);
    this.setScrub(span.from, span.to, shown);
  }

  private drawLayer(
    sheet: LaneCanvas,
    lane: LayerRows,
    actor: number,
    layer: number,
    isFolded: boolean,
  ): void {
    const { past, playback, stage, selection } = this.app;
    const { from, to } = sheet.span;
    const runs = past.runs.between(laneKey(actor, layer), from, to);
    const known = playback.isLive ? runs : upTo(runs, stage.head);
    drawRuns(sheet, known, lane, (state) => selection.stateIndex(actor, state, layer));
    if (isFolded) return;
    drawBlends(sheet, past.events.blendsBetween(actor, layer, from, to), lane);
    drawMarks(sheet, this.wanted(past.events.marksBetween(actor, from, to, layer)), lane);
  }

  /** Returns what the filter lets through. */
  private wanted<T extends { name: string }>(all: readonly T[]): T[] {
    const text = this.app.timeline.filter.value.toLowerCase();
    return all.filter(({ name }) => name.toLowerCase().includes(text));
  }

  /** Sets the lanes' height; with several layers, writes their names beside the lanes. */
  private form(layers: readonly string[], { height, layers: rows }: LaneRows): void {
    const places = rows.map(({ state }) => state);
    const shape = JSON.stringify([layers, height, places, [...this.app.timeline.folded.value]]);
    if (shape === this.shape) return;
    this.shape = shape;
    this.host.style.height = `${height}px`;
    const named = layers.length > 1 ? layers : [];
    const labels = named.map((name) => this.foldButton(name));
    labels.forEach((label, i) => (label.style.top = `${places[i]! - NAME_ABOVE}px`));
    const focused = [...this.names.children].indexOf(document.activeElement!);
    this.names.replaceChildren(...labels);
    labels[focused]?.focus();
    this.host.classList.toggle("named", named.length > 0);
  }

  /** Makes a button that shows a layer's name and folds the layer's lane; every fold makes new buttons. */
  private foldButton(name: string): HTMLButtonElement {
    const { timeline } = this.app;
    const isFolded = timeline.folded.value.has(name);
    const facts = { type: "button", "aria-expanded": String(!isFolded), title: `${name}: fold its lane` };
    const made = el("button", facts, name);
    made.addEventListener("click", () => timeline.fold(name));
    return made;
  }

  private setScrub(from: number, to: number, shown: number): void {
    Object.assign(this.scrub, { min: String(from), max: String(to) });
    this.scrub.value = String(shown);
    this.scrub.setAttribute("aria-valuetext", `tick ${shown} of ${to}`);
  }
}

const within = <T extends { tick: number }>(all: readonly T[], { from, to }: Span): T[] =>
  all.filter(({ tick }) => tick >= from && tick <= to);

export function timelinePanel(_host: HTMLElement, app: App): void {
  const { tools } = new Transport(byId("transport"), app);
  new Timeline(byId("lanes"), tools, app);
  const span = el("div", { id: "span", role: "group", "aria-label": "selected span" });
  tools.after(span);
  spanBar(span, app);
}
