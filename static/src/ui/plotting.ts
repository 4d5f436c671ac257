/** Loads the library that draws plots, the first time that a plot is drawn: the page begins without it. */

import type uPlot from "uplot";

export type Plotting = typeof uPlot;

export async function loadPlotting(): Promise<Plotting> {
  const [{ default: plotting }] = await Promise.all([import("uplot"), import("uplot/dist/uPlot.min.css")]);
  return plotting;
}
