/** Chooses the clip of a state: the present one and all others as film strips. */

import { html, nothing, type TemplateResult } from "lit-html";
import type { Clip } from "../../net/protocol";
import type { BoundField } from "../../state/editingFields";
import { formField } from "../../ui/formField";
import { twins } from "./twins";

const PICTURES = 6;

/** Returns the address of a clip's film strip. */
export function stripAddress(character: string, clip: string): string {
  const query = new URLSearchParams({ clip, frames: String(PICTURES) });
  return `api/characters/${encodeURIComponent(character)}/skeleton.svg?${query.toString()}`;
}

export const strip = (character: string, clip: string): TemplateResult =>
  html`<img
    class="strip"
    loading="lazy"
    src=${stripAddress(character, clip)}
    alt=${`${clip} as a film strip`}
  />`;

/** `others`: texts that can be chosen and are no clip, each with its words. */
export function clipChoice(
  field: BoundField,
  character: string,
  clips: readonly Clip[],
  others: readonly (readonly [string, string])[],
): TemplateResult {
  const words = ({ name, duration }: Clip): string => `${name}, ${duration.toFixed(2)} s`;
  const choices = [...others, ...clips.map((clip) => [clip.name, words(clip)] as const)];
  const isClip = clips.some(({ name }) => name === field.value);
  return html`${formField(field, { label: "clip", choices })}
    ${isClip ? html`${strip(character, field.value)} ${twins(character, field.value)}` : nothing}
    <details class="clips">
      <summary>all clips as pictures</summary>
      ${clips.map(
        (clip) =>
          html`<button
            type="button"
            aria-pressed=${clip.name === field.value}
            @click=${() => field.left(clip.name)}
          >
            <span .textContent=${words(clip)}></span> ${strip(character, clip.name)}
          </button>`,
      )}
    </details>`;
}
