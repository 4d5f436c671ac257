/** Angle, angular speed and acceleration of all curves over time, one plot each. */

import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import type { CurvesView, CurveView } from "../../net/types/api.generated";
import { el, token } from "../../ui/dom";
import { METHODS } from "./methods";

type Quantity = "angle_deg" | "speed_deg" | "acceleration_deg";

const PLOTS: readonly { name: Quantity; words: string }[] = [
  { name: "angle_deg", words: "angle from the first key, °" },
  { name: "speed_deg", words: "angular speed, °/s" },
  { name: "acceleration_deg", words: "angular acceleration, °/s²" },
];
const HEIGHT = 140;
const SPIKES = 0.98;

/** Returns the value that a part of all values does not exceed, with room above: a jump of speed at a key is
 * a spike of acceleration as high as the samples are close. */
export function ceiling(values: readonly number[], part: number): number {
  const rising = [...values].sort((a, b) => a - b);
  const high = rising[Math.floor(part * (rising.length - 1))] ?? 0;
  return high > 0 ? high * 1.15 : 1;
}

export class Plots {
  private readonly plots: { name: Quantity; plot: uPlot }[];

  constructor(private readonly root: HTMLElement) {
    this.plots = PLOTS.map(({ name, words }) => {
      const box = el("div", { class: "plot", "data-quantity": name });
      root.append(el("h2", {}, words), box);
      return { name, plot: new uPlot(this.options(), [[], ...METHODS.map(() => [])], box) };
    });
    new ResizeObserver(() => this.resize()).observe(root);
  }

  private options(): uPlot.Options {
    const axis = (): uPlot.Axis => ({
      stroke: token("--ink-2"),
      grid: { stroke: token("--line"), width: 1 },
      ticks: { stroke: token("--line"), width: 1 },
    });
    return {
      width: Math.max(200, this.root.clientWidth),
      height: HEIGHT,
      scales: { x: { time: false } },
      axes: [axis(), { ...axis(), size: 64 }],
      series: [{}, ...METHODS.map(({ words, colour }) => ({ label: words, stroke: colour, width: 1.5 }))],
      cursor: { y: false, drag: { x: false, y: false }, sync: { key: "curves" } },
    };
  }

  show({ times, curves }: CurvesView): void {
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

  private resize(): void {
    const width = Math.max(200, this.root.clientWidth);
    for (const { plot } of this.plots) plot.setSize({ width, height: HEIGHT });
  }
}
