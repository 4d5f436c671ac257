/** Draws how much of the next motion is seen while it is blended in. */

import { svg as template, type TemplateResult } from "lit-html";

const [WIDTH, HEIGHT, STEPS] = [120, 40, 24];

/** Returns the share 0…1 of the next motion after the part `t` of the blend, as the server blends. */
export function share(curve: "cubic" | "quintic", t: number): number {
  const left = 1 - t;
  return curve === "cubic" ? 1 - (3 - 2 * left) * left ** 2 : 1 - (5 - 4 * left) * left ** 4;
}

export function blendCurve(curve: "cubic" | "quintic", seconds: number): TemplateResult {
  const points = Array.from({ length: STEPS + 1 }, (_, i) => {
    const t = i / STEPS;
    return `${(t * WIDTH).toFixed(1)},${(HEIGHT - share(curve, t) * HEIGHT).toFixed(1)}`;
  });
  const line = seconds > 0 ? points.join(" ") : `0,${HEIGHT} 0,0 ${WIDTH},0`;
  return template`<svg class="blend-curve" viewBox="-2 -2 ${WIDTH + 4} ${HEIGHT + 4}" role="img"
    aria-label="${curve}, ${seconds} s"><polyline points=${line} fill="none" /></svg>`;
}
