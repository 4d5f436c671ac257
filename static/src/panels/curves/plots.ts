/** Angle, angular speed and acceleration of all curves over time, one plot each. */

import type uPlot from "uplot";
import type { CurvesView, CurveView } from "../../net/types/api.generated";
import { el, token } from "../../ui/dom";
import type { Plotting } from "../../ui/plotting";
import { METHODS } from "./methods";

type Quantity = "angle_deg" | "speed_deg" | "acceleration_deg";

const PLOTS: readonly { name: Quantity; words: string }[] = [
  { name: "angle_deg", words: "angle from the first key, °" },
  { name: "speed_deg", words: "angular speed, °/s" },
  { name: "acceleration_deg", words: "angular acceleration, °/s²" },
];
const HEIGHT = 140;
const LABEL = 22;
const SPIKES = 0.98;

/** Returns the value that a part of all values does not exceed, with room above: a jump of speed at a key is
 * a spike of acceleration as high as the samples are close. */
export function ceiling(values: readonly number[], part: number): number {
  const rising = [...values].sort((a, b) => a - b);
  const high = rising[Math.floor(part * (rising.length - 1))] ?? 0;
  return high > 0 ? high * 1.15 : 1;
}

/** Returns the value of sampled rows at a time between them. */
export function valueAt(times: readonly number[], values: readonly number[], time: number): number {
  const after = Math.max(
    1,
    times.findIndex((at) => at >= time),
  );
  const [t0, t1] = [times[after - 1], times[after]];
  const [v0, v1] = [values[after - 1], values[after]];
  if (t0 === undefined || t1 === undefined || v0 === undefined || v1 === undefined) return 0;
  return v0 + ((v1 - v0) * (time - t0)) / (t1 - t0);
}

export class Plots {
  private keys: readonly { time: number; angle: number }[] = [];
  private readonly plots: { name: Quantity; plot: uPlot }[];

  constructor(
    plotting: Plotting,
    private readonly root: HTMLElement,
  ) {
    this.plots = PLOTS.map(({ name, words }) => {
      const box = el("div", { class: "plot", "data-quantity": name });
      root.append(el("h2", {}, words), box);
      const last = name === PLOTS.at(-1)?.name;
      const options = this.options(name === "angle_deg", last ? "time, s" : "");
      return { name, plot: new plotting(options, [[], ...METHODS.map(() => [])], box) };
    });
    new ResizeObserver(() => this.resize()).observe(root);
  }

  private options(hasDots: boolean, label: string): uPlot.Options {
    const axis = (): uPlot.Axis => ({
      stroke: token("--ink-2"),
      grid: { stroke: token("--line"), width: 1 },
      ticks: { stroke: token("--line"), width: 1 },
    });
    return {
      width: Math.max(200, this.root.clientWidth),
      height: HEIGHT + (label ? LABEL : 0),
      scales: { x: { time: false } },
      axes: [label ? { ...axis(), label, labelSize: LABEL } : axis(), { ...axis(), size: 64 }],
      hooks: { draw: [(plot) => this.mark(plot, hasDots)] },
      series: [{}, ...METHODS.map(({ words, colour }) => ({ label: words, stroke: colour, width: 1.5 }))],
      cursor: { y: false, drag: { x: false, y: false }, sync: { key: "curves" } },
    };
  }

  /** Takes the curves, and the times of the keys: each key is a dotted line, and a dot at its angle. */
  show({ times, curves }: CurvesView, keyTimes: readonly number[]): void {
    const passing = curves.find(({ interpolation }) => interpolation === "slerp")?.angle_deg ?? [];
    this.keys = keyTimes.map((time) => ({ time, angle: valueAt(times, passing, time) }));
    for (const { name, plot } of this.plots) {
      const rows = curves.map((curve: CurveView) => (curve.refused ? times.map(() => null) : curve[name]));
      plot.setData([times, ...rows], false);
      const numbers = curves.flatMap((curve) => curve[name]);
      plot.setScale("x", { min: times[0] ?? 0, max: times.at(-1) ?? 1 });
      plot.setScale("y", { min: 0, max: ceiling(numbers, name === "acceleration_deg" ? SPIKES : 1) });
    }
  }

  /** Shows or hides a curve in all plots. */
  toggle(row: number, shown: boolean): void {
    for (const { plot } of this.plots) plot.setSeries(row + 1, { show: shown });
  }

  /** Puts the vertical line at a time in seconds. */
  point(time: number): void {
    const first = this.plots[0]?.plot;
    if (first) first.setCursor({ left: first.valToPos(time, "x"), top: 0 });
  }

  /** Draws the keys above a plot. */
  private mark(plot: uPlot, hasDots: boolean): void {
    const { ctx, bbox } = plot;
    ctx.save();
    ctx.strokeStyle = token("--ink-3");
    ctx.fillStyle = token("--ink");
    ctx.setLineDash([2, 4]);
    for (const { time, angle } of this.keys) {
      const x = plot.valToPos(time, "x", true);
      ctx.beginPath();
      ctx.moveTo(x, bbox.top);
      ctx.lineTo(x, bbox.top + bbox.height);
      ctx.stroke();
      if (!hasDots) continue;
      ctx.beginPath();
      ctx.arc(x, plot.valToPos(angle, "y", true), 3.5 * devicePixelRatio, 0, 2 * Math.PI);
      ctx.fill();
    }
    ctx.restore();
  }

  private resize(): void {
    const width = Math.max(200, this.root.clientWidth);
    for (const { plot } of this.plots) plot.setSize({ width, height: plot.height });
  }
}
