/** Plots the turns of the picked joint over time; the library that plots is loaded when a plot is wanted. */

import type uPlot from "uplot";
import { el, token } from "../../ui/dom";
import { loadPlotting } from "../../ui/plotting";
import type { JointTrack } from "./jointTrack";

const HEIGHT = 100;
/** Between two drawings. */
const REST_MS = 100;
const AXES = [
  ["x", "--accent"],
  ["y", "--ink"],
  ["z", "--ink-3"],
] as const;

/** Makes the words over the plot, in the colours of its lines. */
function legend(): HTMLElement {
  const names = AXES.map(([name, colour]) => {
    const word = el("b", {}, name);
    word.style.color = `var(${colour})`;
    return word;
  });
  return el("p", {}, "turns, ° over s: ", ...names);
}

export class JointPlot {
  readonly box = el("div", { class: "joint-plot", hidden: true });
  private plot: uPlot | null = null;
  private last = 0;

  constructor(private readonly track: JointTrack) {}

  async show(on: boolean): Promise<void> {
    this.box.hidden = !on;
    if (!on || this.box.hasChildNodes()) return;
    this.box.append(legend());
    const plotting = await loadPlotting();
    this.plot = new plotting(this.options(), [[], [], [], []], this.box);
    new ResizeObserver(() => this.plot?.setSize({ width: this.width, height: HEIGHT })).observe(this.box);
  }

  private get width(): number {
    return this.box.clientWidth;
  }

  private options(): uPlot.Options {
    const axis = (): uPlot.Axis => ({
      stroke: () => token("--ink-2"),
      grid: { stroke: () => token("--line"), width: 1 },
      ticks: { stroke: () => token("--line"), width: 1 },
    });
    const lines = AXES.map(([label, colour]) => ({ label, stroke: () => token(colour), width: 1.5 }));
    return {
      width: this.width,
      height: HEIGHT,
      scales: { x: { time: false } },
      axes: [axis(), { ...axis(), size: 40, space: 20 }],
      legend: { show: false },
      series: [{ label: "s" }, ...lines],
      cursor: { drag: { x: false, y: false } },
    };
  }

  /** Draws the track; `rate`: ticks per second. */
  update(now: number, rate: number): void {
    if (this.box.hidden || !this.plot || now - this.last < REST_MS) return;
    this.last = now;
    this.plot.setData([this.track.ticks.map((tick) => tick / rate), ...this.track.turns]);
  }
}
