/** How a capture is read: what its positions mean, and what is taken out of its motion. */

import { html, nothing, type TemplateResult } from "lit-html";

/** Hz, as the server allows. */
const HIGHEST = 1000;

export function readingForm({ name }: File): TemplateResult {
  const added = html`<label
    ><input type="checkbox" name="added" />add positions to the offsets of joints</label
  >`;
  return html`<div class="reading-form">
    ${/\.bvh$/i.test(name) ? added : nothing}
    <label><input type="checkbox" name="spikes" />take spikes out</label>
    <label>
      low-pass
      <input
        type="number"
        name="low-pass"
        min="0"
        max=${HIGHEST}
        step="any"
        placeholder="none"
        aria-label="low-pass filter, Hz"
      />
      Hz
    </label>
  </div>`;
}

/** `adds`: whether positions are added to the offsets of joints. */
export const readingOf = (fields: FormData): { adds: boolean; low_pass: number; spikes: boolean } => ({
  adds: fields.has("added"),
  low_pass: Number(fields.get("low-pass")) || 0,
  spikes: fields.has("spikes"),
});
