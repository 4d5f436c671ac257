/** The curve of a blend, chosen by its picture: how much of the next motion is seen while it is blended in. */

import { html, nothing, svg as template, type TemplateResult } from "lit-html";
import type { BoundField } from "../../state/editingFields";

type Curve = "cubic" | "quintic";

const CURVES: readonly (readonly [Curve, string])[] = [
  ["cubic", "cubic"],
  ["quintic", "quintic: softer at its end"],
];

const [WIDTH, HEIGHT, STEPS] = [120, 40, 24];

/** Returns the share 0…1 of the next motion after the part `t` of the blend, as the server blends. */
export function share(curve: Curve, t: number): number {
  const left = 1 - t;
  return curve === "cubic" ? 1 - (3 - 2 * left) * left ** 2 : 1 - (5 - 4 * left) * left ** 4;
}

/** Draws a button for each curve, with the curve of a blend of `seconds`. */
export function curveChoice(field: BoundField, seconds: number): TemplateResult {
  return html`<div class="curve-choice" role="group" aria-label="curve">
    ${CURVES.map(
      ([curve, words]) =>
        html`<button
          type="button"
          aria-label=${words}
          title=${words}
          aria-pressed=${curve === field.value}
          @click=${() => field.left(curve)}
        >
          ${blendCurve(curve, seconds)} <span .textContent=${curve}></span>
        </button>`,
    )}
    ${field.error ? html`<p class="field-error" role="alert" .textContent=${field.error}></p>` : nothing}
  </div>`;
}

function blendCurve(curve: Curve, seconds: number): TemplateResult {
  const points = Array.from({ length: STEPS + 1 }, (_, i) => {
    const t = i / STEPS;
    return `${(t * WIDTH).toFixed(1)},${(HEIGHT - share(curve, t) * HEIGHT).toFixed(1)}`;
  });
  const line = seconds > 0 ? points.join(" ") : `0,${HEIGHT} 0,0 ${WIDTH},0`;
  return template`<svg class="blend-curve" viewBox="-2 -2 ${WIDTH + 4} ${HEIGHT + 4}" aria-hidden="true"><polyline points=${line} fill="none" /></svg>`;
}
