/** The form of a state: its name, its motion, its markers. */

import type { Signal } from "@preact/signals-core";
import { html, nothing, type TemplateResult } from "lit-html";
import type { LayerInfo, MachineInfo, Operation, StateInfo } from "../../net/protocol";
import type { EditingFields } from "../../state/editingFields";
import { numberOrName, numberText } from "../../state/fieldTexts";
import { formField } from "../../ui/formField";
import type { App } from "../../view/app";
import { FRAMINGS } from "../../view/camera/framing";
import { blendForm, newBlend } from "./blendForm";
import type { Drag } from "./blendPad";
import { clipChoice } from "./clipChoice";
import { contactFields } from "./contactFields";
import { groundSpeedOf, groundSpeedText } from "./groundSpeedTexts";
import { markerFields } from "./markerFields";

const YES_NO = [
  ["no", "no"],
  ["yes", "yes"],
] as const;
const FRAMING_CHOICES: readonly (readonly [string, string])[] = [
  ["", "as the viewer chose"],
  ...FRAMINGS.map((framing) => [framing, framing] as const),
];
const yes = (flag: boolean): string => (flag ? "yes" : "no");

type StateFields = Extract<Operation, { kind: "set_state" }>["fields"];

export function stateForm(
  app: App,
  fields: EditingFields,
  drag: Signal<Drag | null>,
  layer: LayerInfo,
  name: string,
): TemplateResult {
  const info = layer.states.find((state) => state.name === name);
  const composite = layer.composites.find((state) => state.name === name);
  const state = { state: name, layer: layer.name };
  const outer = (info ?? composite)?.outer ?? "";
  const short = outer ? name.slice(outer.length + 1) : name;
  const own = fields.bind("name", short, (to) => [{ kind: "rename_state", ...state, to: to.trim() }]);
  const flag = (member: "loop" | "final" | "resume", value: boolean, label: string): TemplateResult => {
    const field = fields.bind(member, yes(value), (text) => set({ [member]: text === "yes" }));
    return formField(field, { label, choices: YES_NO });
  };
  const set = (members: StateFields): Operation[] => [{ kind: "set_state", ...state, fields: members }];
  const isFinal = (info ?? composite)?.final ?? false;
  return html`<h2 .textContent=${name}></h2>
    ${formField(own, { label: "name" })} ${info ? motionFields(app, fields, drag, layer, info) : nothing}
    ${info && info.motion !== null ? html`${flag("loop", info.loop, "loops")} ${speedField(app, fields, info, set)}` : nothing}
    ${info?.duration && layer.name === "base" ? groundSpeedField(app, fields, info, set) : nothing}
    ${info ? framingField(fields, info, set) : nothing}
    ${composite ? flag("resume", composite.resume, "resumes where it was left") : nothing}
    ${outer ? flag("final", isFinal, `ends ${outer}`) : nothing}
    ${info ? initialButton(app, layer, info) : nothing} ${info ? markers(fields, state, info) : nothing}
    ${info ? contactFields(fields, app.contacts, info) : nothing}`;
}

function speedField(
  { machine }: App,
  fields: EditingFields,
  { speed }: StateInfo,
  set: (members: StateFields) => Operation[],
): TemplateResult {
  const field = fields.bind("speed", typeof speed === "number" ? numberText(speed) : speed, (text) =>
    set({ speed: numberOrName(text) }),
  );
  return formField(field, {
    label: "speed",
    hint: "1, or a parameter",
    proposals: numbersOf(machine.info.value),
  });
}

function groundSpeedField(
  { contacts }: App,
  fields: EditingFields,
  { motion, clips, ground_speed: known }: StateInfo,
  set: (members: StateFields) => Operation[],
): TemplateResult {
  const field = fields.bind("ground speed", groundSpeedText(known), (text) =>
    set({ ground_speed: groundSpeedOf(text) }),
  );
  const drifts = (clips.length ? clips : [motion]).map((clip) =>
    Math.hypot(...(contacts.of(clip)?.drift ?? [0])),
  );
  const speeds = drifts.filter((speed) => speed > 0).map((speed) => speed.toFixed(2));
  const found = speeds.length ? `found: ${speeds.join(" … ")} m/s` : "";
  return html`${formField(field, {
    label: "ground speed",
    hint: found || "m/s besides the clip's own way",
    proposals: found ? ["found"] : [],
  })}
  ${known === "found" ? html`<p class="hint" .textContent=${found}></p>` : nothing}`;
}

function framingField(
  fields: EditingFields,
  { framing }: StateInfo,
  set: (members: StateFields) => Operation[],
): TemplateResult {
  const field = fields.bind("framing", framing ?? "", (text) =>
    set({ framing: FRAMINGS.find((known) => known === text) ?? null }),
  );
  return formField(field, { label: "framing", hint: "what the camera shows", choices: FRAMING_CHOICES });
}

/** Returns the names of a machine's number parameters. */
const numbersOf = (info: MachineInfo | null): string[] =>
  (info?.parameters ?? []).filter(({ kind }) => kind === "number").map(({ name }) => name);

function initialButton(
  { editing }: App,
  { name: layer, initial, composites }: LayerInfo,
  { name, outer }: StateInfo,
): TemplateResult {
  const isInitial = (composites.find((state) => state.name === outer)?.initial ?? initial) === name;
  return html`<button
    type="button"
    class="wide"
    ?disabled=${isInitial}
    .textContent=${isInitial ? "it is the first state" : "make it the first state"}
    @click=${() => void editing.operate([{ kind: "set_initial", state: name, layer }])}
  ></button>`;
}

function motionFields(
  app: App,
  fields: EditingFields,
  drag: Signal<Drag | null>,
  layer: LayerInfo,
  info: StateInfo,
): TemplateResult {
  const { library, machine } = app;
  const { name, motion } = info;
  if (info.over.length) return blendForm(app, fields, drag, layer.name, info);
  const isBase = layer.name === "base";
  const field = fields.bind("motion", motion ?? (isBase ? "" : "none"), (text) => [
    { kind: "set_state", state: name, layer: layer.name, fields: { motion: text } },
  ]);
  const character = machine.info.value?.character ?? "";
  const others = [["", "the pose at rest"], ...(isBase ? [] : [["none", "none"]])] as [string, string][];
  return html`${clipChoice(field, character, library.clipsOf(character), others)}
  ${newBlend(app, fields, layer.name, info)}`;
}

/** Draws the markers of a state. The markers of a blend's clips are drawn beside the clips; a blend can have markers of its own, too. */
function markers(
  fields: EditingFields,
  state: { state: string; layer: string },
  { motion, over, markers: known }: StateInfo,
): TemplateResult {
  const shown = over.length ? known.filter(({ written }) => written) : known;
  if (motion === null || (over.length && !shown.length)) return html``;
  return html`<fieldset>
    <legend>markers</legend>
    ${markerFields(fields, state, "", shown)}
  </fieldset>`;
}
