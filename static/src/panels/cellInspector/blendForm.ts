/** The form of a blend: its pad, its clips in numbers, how one clip becomes a blend, and a blend one clip. */

import type { Signal } from "@preact/signals-core";
import { html, nothing, type TemplateResult } from "lit-html";
import { repeat } from "lit-html/directives/repeat.js";
import type { Marker, Parameter, StateInfo } from "../../net/protocol";
import type { EditingFields } from "../../state/editingFields";
import { formField } from "../../ui/formField";
import type { App } from "../../view/app";
import { BlendPad, type Drag } from "./blendPad";
import { axesOf, blendOver, makeBlend, middle, oneClip, placeOf, putClip } from "./blendSpace";
import { markerFields } from "./markerFields";

/** The parameter of a new blend. */
const PACE = "pace";

export function blendForm(
  app: App,
  fields: EditingFields,
  drag: Signal<Drag | null>,
  layer: string,
  info: StateInfo,
): TemplateResult {
  const { machine, library, selection, travel } = app;
  const axes = axesOf(info, machine.info.value?.parameters ?? []);
  const state = { state: info.name, layer };
  const others = library
    .clipsOf(machine.info.value?.character ?? "")
    .filter(({ name }) => !info.clips.includes(name));
  const added = fields.bind("blend new", "", (clip) => putClip(state, clip, middle(axes)));
  const alone = fields.bind("one clip", "", (clip) => oneClip(state, info, clip));
  const isThere = layer !== "base" || selection.shownState === info.name;
  return html`${overField(fields, state, info, machine.info.value?.parameters ?? [])}
    ${new BlendPad(app, drag, layer, info).template()}
    ${
      isThere
        ? nothing
        : html`<button type="button" class="wide" @click=${() => void travel.go(info.name)}>
            see it: go to ${info.name}
          </button>`
    }
    <fieldset>
      <legend title="phases of the state are phases of the first clip">clips</legend>
      ${repeat(
        info.clips,
        (clip) => clip,
        (clip) => clipRow(fields, state, info, clip, (text) => placeOf(text, axes)),
      )}
      ${formField(added, {
        label: "one more",
        choices: [["", "choose …"], ...others.map(({ name }) => [name, name] as const)],
      })}
    </fieldset>
    ${formField(alone, {
      label: "one clip",
      choices: [["", "in place of the blend …"], ...info.clips.map((clip) => [clip, clip] as const)],
    })}`;
}

/** Draws the field of what the clips are blended over. */
function overField(
  fields: EditingFields,
  state: { state: string; layer: string },
  info: StateInfo,
  parameters: readonly Parameter[],
): TemplateResult {
  const field = fields.bind("blend over", info.over.join(", "), (text) =>
    blendOver(state, info, text, parameters),
  );
  return formField(field, { label: "over", hint: "pace; or two: pace, turn" });
}

function clipRow(
  fields: EditingFields,
  state: { state: string; layer: string },
  { points, clips, clip_markers }: StateInfo,
  clip: string,
  read: (text: string) => number[],
): TemplateResult {
  const field = fields.bind(`blend ${clip}`, (points[clip] ?? []).join(", "), (text) =>
    putClip(state, clip, read(text)),
  );
  const without = fields.bind(`blend without ${clip}`, "", () => [
    { kind: "delete_blend_clip", ...state, clip },
  ]);
  const before = clips[clips.indexOf(clip) - 1];
  const earlier = fields.bind(`blend ${clip} earlier`, "", () => [
    { kind: "move_blend_clip", ...state, clip, before: before ?? null },
  ]);
  return html`${formField(field, { label: clip, hint: "its place" })}
    <p class="buttons">
      ${before === undefined ? nothing : button(`move ${clip} up`, "up", () => earlier.left("up"))}
      ${clips.length > 2 ? button(`take ${clip} out`, "take out", () => without.left("out")) : nothing}
    </p>
    ${clipMarkers(fields, state, clip, clip_markers[clip] ?? [])}`;
}

const button = (label: string, words: string, act: () => void): TemplateResult =>
  html`<button type="button" aria-label=${label} .textContent=${words} @click=${act}></button>`;

/** Draws the markers of a clip, folded: clips with common markers run in step. */
const clipMarkers = (
  fields: EditingFields,
  state: { state: string; layer: string },
  clip: string,
  markers: readonly Marker[],
): TemplateResult =>
  html`<details class="markers">
    <summary
      .textContent=${`markers of ${clip}: ${markers.map(({ name }) => name).join(", ") || "none"}`}
    ></summary>
    ${markerFields(fields, state, clip, markers)}
  </details>`;

/** Draws the field that makes a blend of a state's clip and another. */
export function newBlend(
  { machine, library }: App,
  fields: EditingFields,
  layer: string,
  { name, motion }: StateInfo,
): TemplateResult {
  const info = machine.info.value;
  const clips = library.clipsOf(info?.character ?? "");
  if (!info || !clips.some((clip) => clip.name === motion)) return html``;
  const field = fields.bind("blend with", "", (clip) =>
    makeBlend({ state: name, layer }, [motion!, clip], PACE, info.parameters),
  );
  const others = clips.filter((clip) => clip.name !== motion).map((clip) => [clip.name, clip.name] as const);
  return formField(field, {
    label: "blend with",
    choices: [["", "another clip …"], ...others],
  });
}
