/** Puts the page together that compares interpolations: keys on the left, figures above, plots below. */

import "./style/tokens.css";
import "./style/base.css";
import "./style/components.css";
import "./style/layout.css";
import "./panels/curves/curves.css";
import { compareCurves } from "./net/api";
import type { CurvesView } from "./net/types/api.generated";
import { read, written } from "./panels/curves/curvesAddress";
import { Figures } from "./panels/curves/figures";
import { KeyStrip } from "./panels/curves/keyStrip";
import { EXAMPLES, fault, KeyTable, type Key } from "./panels/curves/keyTable";
import { METHODS } from "./panels/curves/methods";
import { Plots } from "./panels/curves/plots";
import { byId, canvasById, el, reducedMotion, say } from "./ui/dom";
import { loadPlotting } from "./ui/plotting";

const SAMPLES = 361;
const ASK_MS = 120;

class Clock {
  playing = !reducedMotion();
  time = 0;
  private first = 0;
  private last = 1;
  private readonly slider = el("input", { type: "range", min: 0, max: 1, step: "any", "aria-label": "time" });
  private readonly button = el("button", { type: "button" }, "pause");
  private readonly shown = el("output", {});

  constructor(root: HTMLElement) {
    root.append(this.button, this.slider, this.shown);
    this.button.addEventListener("click", () => (this.playing = !this.playing));
    this.slider.addEventListener("input", () => {
      this.playing = false;
      this.time = this.first + this.slider.valueAsNumber * (this.last - this.first);
    });
  }

  /** The fraction 0…1 of the time that has passed. */
  get part(): number {
    return (this.time - this.first) / (this.last - this.first);
  }

  span(first: number, last: number): void {
    [this.first, this.last] = [first, last];
    this.time = Math.min(last, Math.max(first, this.time));
  }

  advance(seconds: number): void {
    if (this.playing) {
      this.time += seconds;
      if (this.time > this.last) this.time = this.first;
    }
    this.slider.valueAsNumber = this.part;
    say(this.button, this.playing ? "pause" : "play");
    say(this.shown, `${this.time.toFixed(2)} s`);
  }
}

/**
 * Asks the server for the curves, once the keys have rested for a moment. An answer about earlier keys is dropped, also
 * while a key is wrong.
 */
class Asker {
  private timer = 0;
  private asked = 0;

  constructor(private readonly take: (curves: CurvesView, keys: readonly Key[]) => void) {}

  ask(keys: readonly Key[]): void {
    window.clearTimeout(this.timer);
    const wrong = fault(keys);
    say(byId("refused"), wrong);
    if (wrong) this.asked++;
    else this.timer = window.setTimeout(() => void this.send(keys), ASK_MS);
  }

  private async send(keys: readonly Key[]): Promise<void> {
    const number = ++this.asked;
    const interpolations = METHODS.map(({ name }) => name);
    try {
      const curves = await compareCurves({
        keys: keys.map((key) => ({ ...key })),
        interpolations,
        samples: SAMPLES,
      });
      if (number === this.asked) this.take(curves, keys);
    } catch (error) {
      say(byId("refused"), error instanceof Error ? error.message : String(error));
    }
  }
}

/** Makes a button for each interpolation, which shows and hides it. */
function nameButtons(): void {
  for (const [row, { name, words, colour }] of METHODS.entries()) {
    const swatch = el("span", { class: "swatch" });
    swatch.style.background = colour;
    const button = el("button", { type: "button" }, swatch, words);
    const show = (): void => {
      const isShown = !hidden.has(name);
      button.setAttribute("aria-pressed", String(isShown));
      plots.toggle(row, isShown);
      figures.reveal(row);
    };
    button.addEventListener("click", () => {
      if (!hidden.delete(name)) hidden.add(name);
      show();
      keep();
    });
    show();
    byId("names").append(el("li", {}, button));
  }
}

/** Keeps in the address what is compared. */
function keep(): void {
  history.replaceState(null, "", written(compared, hidden));
  say(byId("link"), "copy a link");
}

async function copyLink(): Promise<void> {
  const copied = await navigator.clipboard.writeText(location.href).then(
    () => "copied",
    () => "the link is in the address bar",
  );
  say(byId("link"), copied);
}

const { keys: asked, hidden } = read(location.search);
let compared = asked ?? EXAMPLES["a wave"]!;
const figures = new Figures(canvasById("figures"), hidden);
const plots = new Plots(await loadPlotting(), byId("plots"));
const clock = new Clock(byId("clock"));
const asker = new Asker((curves, keys) => {
  figures.show(curves.curves);
  plots.show(
    curves,
    keys.map(({ time }) => time),
  );
  clock.span(curves.times[0] ?? 0, curves.times.at(-1) ?? 1);
  const refused = curves.curves.find((curve) => curve.refused);
  say(byId("refused"), refused ? `${refused.interpolation}: ${refused.refused}` : "");
  document.body.dataset["curves"] = String(curves.curves.length);
  compared = keys.map((key) => ({ ...key }));
  keep();
});
nameButtons();
byId("link").addEventListener("click", () => void copyLink());
const strip = new KeyStrip(byId("strip"), (row, time) => table.move(row, time));
const table = new KeyTable(byId("keys"), byId("examples"), compared, (keys) => {
  strip.show(keys);
  asker.ask(keys);
});
let last = performance.now();
const loop = (now: number): void => {
  clock.advance(Math.min(0.1, Math.max(0, (now - last) / 1000)));
  last = now;
  figures.draw(clock.part);
  plots.point(clock.time);
  requestAnimationFrame(loop);
};
requestAnimationFrame(loop);
