/** Draws templates that follow signals. */

import { effect } from "@preact/signals-core";
import { type noChange, render, type TemplateResult } from "lit-html";

/**
 * Draws a template into `host`, and again when a signal changes whose value it reads (`noChange` leaves what is
 * drawn); returns a function that ends it.
 */
export function draw(host: HTMLElement, template: () => TemplateResult | typeof noChange): () => void {
  return effect(() => {
    render(template(), host);
  });
}
