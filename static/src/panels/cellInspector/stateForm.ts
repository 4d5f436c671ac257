/** The form of a state: its name, its motion, its markers. */

import { html, nothing, type TemplateResult } from "lit-html";
import type { LayerInfo, StateInfo } from "../../net/protocol";
import type { EditingFields } from "../../state/editingFields";
import { formField } from "../../ui/formField";
import type { App } from "../../view/app";

const YES_NO = [
  ["no", "no"],
  ["yes", "yes"],
] as const;
const yes = (flag: boolean): string => (flag ? "yes" : "no");

/** Reads a phase of a marker; blank takes the marker away. */
function phase(text: string): number | null {
  if (!text.trim()) return null;
  const value = Number(text);
  if (!(value >= 0 && value <= 1)) throw new Error("a phase from 0 to 1; blank: no marker");
  return value;
}

export function stateForm(app: App, fields: EditingFields, layer: LayerInfo, name: string): TemplateResult {
  const info = layer.states.find((state) => state.name === name);
  const state = { state: name, layer: layer.name };
  const short = info?.outer ? name.slice(info.outer.length + 1) : name;
  const own = fields.bind("name", short, (to) => [{ kind: "rename_state", ...state, to }]);
  if (!info)
    return html`<h2 .textContent=${name}></h2>
      ${formField(own, { label: "name" })}`;
  const loop = fields.bind("loop", yes(info.loop), (text) => [
    { kind: "set_state", ...state, fields: { loop: text === "yes" } },
  ]);
  const isInitial = layer.initial === name;
  return html`<h2 .textContent=${name}></h2>
    ${formField(own, { label: "name" })} ${motionFields(app, fields, layer, info)}
    ${info.motion === null ? nothing : formField(loop, { label: "loops", choices: YES_NO })}
    <button
      type="button"
      class="wide"
      ?disabled=${isInitial}
      .textContent=${isInitial ? "it is the first state" : "make it the first state"}
      @click=${() => void app.editing.operate([{ kind: "set_initial", ...state }])}
    ></button>
    ${markers(fields, state, info)}`;
}

function motionFields(
  { library, machine }: App,
  fields: EditingFields,
  layer: LayerInfo,
  { name, motion, over, clips }: StateInfo,
): TemplateResult {
  const state = { state: name, layer: layer.name };
  const known = library.clipsOf(machine.info.value?.character ?? "");
  const choices = [
    ["", "the pose at rest"],
    ...(layer.name === "base" ? [] : [["none", "none"] as const]),
    ...known.map((clip) => [clip.name, `${clip.name}, ${clip.duration.toFixed(2)} s`] as const),
  ] as const;
  if (over.length)
    return html`<p
      class="hint"
      .textContent=${`Blends ${clips.join(", ")} over ${over.join(" and ")}.`}
    ></p>`;
  const field = fields.bind("motion", motion ?? (layer.name === "base" ? "" : "none"), (text) => [
    { kind: "set_state", ...state, fields: { motion: text } },
  ]);
  return formField(field, { label: "clip", choices });
}

function markers(
  fields: EditingFields,
  state: { state: string; layer: string },
  { motion, over, markers: known }: StateInfo,
): TemplateResult {
  if (motion === null || over.length) return html``;
  const added = fields.bind("new marker", "", (text) => {
    const [, marker, at] = /^\s*(\S+)\s+([\d.]+)\s*$/.exec(text) ?? [];
    if (!marker || !at) throw new Error("a name and a phase, as in: left-down 0.25");
    return [{ kind: "set_marker", ...state, marker, phase: phase(at) }];
  });
  return html`<fieldset>
    <legend>markers</legend>
    ${known.map(({ name, phase: at }) =>
      formField(
        fields.bind(`marker ${name}`, String(at), (text) => [
          { kind: "set_marker", ...state, marker: name, phase: phase(text) },
        ]),
        { label: name, hint: "0…1; blank deletes it" },
      ),
    )}
    ${formField(added, { label: "new", hint: "left-down 0.25" })}
  </fieldset>`;
}
