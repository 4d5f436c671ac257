/** The form of a cell: its next state, when it fires, how it blends, and its alternatives. */

import { html, nothing, type TemplateResult } from "lit-html";
import type { Cell, LayerInfo } from "../../net/protocol";
import type { CellPlace } from "../../state/editAnswer";
import type { EditingFields } from "../../state/editingFields";
import { formField } from "../../ui/formField";
import type { App } from "../../view/app";
import { alternativesForm, newAlternative } from "./alternativesForm";
import { curveChoice } from "./blendCurve";
import {
  blendField,
  cellOf,
  enterField,
  isWritten,
  seconds,
  setFields,
  setTarget,
  setWhen,
  targetText,
} from "./cellValues";

export function cellForm(
  app: App,
  fields: EditingFields,
  layer: LayerInfo,
  place: CellPlace,
): TemplateResult {
  const cell = cellOf(layer, place);
  const name = place.state === "*" ? "every state" : place.state;
  const event = place.event === "*" ? "every event" : place.event;
  return html`<h2><span .textContent=${name}></span> <span .textContent=${event}></span></h2>
    ${source(app, cell, place)} ${target(fields, layer, place, cell)}
    ${cell && targetText(cell) !== "-" ? details(app, fields, layer, place, cell) : nothing}`;
}

/** Says where the cell is written, if that is elsewhere. */
function source(app: App, cell: Cell | undefined, place: CellPlace): TemplateResult {
  if (!cell) return html`<p class="hint">Blank: the event waits here for its buffer.</p>`;
  if (isWritten(cell, place)) return html``;
  const [state, event] = cell.written;
  const go = (): void => void (app.inspection.selected.value = { layer: place.layer, state, event });
  return html`<p class="hint">
    <span
      .textContent=${`It comes from the default ${state}/${event}; a change makes a cell of its own.`}
    ></span>
    <button type="button" @click=${go}>edit the default</button>
  </p>`;
}

function target(
  fields: EditingFields,
  layer: LayerInfo,
  place: CellPlace,
  cell: Cell | undefined,
): TemplateResult {
  if (cell?.alternatives.length) return alternativesForm(fields, layer, place, cell);
  const states = [...new Set(layer.states.flatMap(({ name, outer }) => (outer ? [outer, name] : [name])))];
  const choices = [
    ["", "blank: waits"],
    ["-", "– means nothing"],
    ...states.map((state) => [state, state] as const),
    ...states.map((state) => [`${state}!`, `${state}! from its beginning`] as const),
  ] as const;
  const to = fields.bind("to", targetText(cell), (text) => setTarget(place, cell, text));
  return formField(to, { label: "next state", choices });
}

function moments(layer: LayerInfo, { state }: CellPlace, when: string): (readonly [string, string])[] {
  const motion = layer.states.find(({ name }) => name === state);
  const markers = motion ? motion.markers : layer.states.flatMap((other) => other.markers);
  const names = [...new Set(markers.map(({ name }) => name))];
  return [
    ["now", "at once"],
    ["end", "at the end of the motion"],
    ...names.map((name) => [`marker ${name}`, `at the marker ${name}`] as const),
    ["window", "in a window …"],
    ...(when.startsWith("window") ? [[when, when] as const] : []),
  ];
}

function details(
  { machine }: App,
  fields: EditingFields,
  layer: LayerInfo,
  place: CellPlace,
  cell: Cell,
): TemplateResult {
  const actions = new Set(
    (machine.info.value?.layers ?? []).flatMap(({ table }) =>
      Object.values(table).flatMap((row) => Object.values(row).flatMap(({ action }) => action ?? [])),
    ),
  );
  const when = fields.bind("when", cell.when, (text) =>
    setWhen(place, cell, text === "window" ? "window 0.2..0.8" : text),
  );
  const [, first = "", last = ""] = /^window ([\d.]+?)\.\.([\d.]+)$/.exec(cell.when) ?? [];
  const bounds = fields.bind("window", `${first}..${last}`, (text) =>
    setFields(place, { when: `window ${text}` }),
  );
  const blend = fields.bind("blend", String(Number(cell.blend.toFixed(4))), (text) =>
    setFields(place, { blend: blendField(seconds(text), cell.curve) ?? null }),
  );
  const curve = fields.bind("curve", cell.curve, (text) =>
    setFields(place, { blend: blendField(cell.blend, text as Cell["curve"]) ?? null }),
  );
  const enter = fields.bind("enter", cell.enter === 0 ? "" : String(cell.enter), (text) =>
    setFields(place, { enter: enterField(text) ?? null }),
  );
  const action = fields.bind("action", cell.action ?? "", (text) =>
    setFields(place, { action: text.trim() || null }),
  );
  return html`${formField(when, { label: "fires", choices: moments(layer, place, cell.when) })}
  ${first ? formField(bounds, { label: "window", hint: "0.2..0.8" }) : nothing}
  ${
    cell.alternatives.length
      ? nothing
      : html`${formField(blend, { label: "blend, s", number: true, step: 0.05 })}
        ${curveChoice(curve, cell.blend)}
        ${formField(enter, { label: "enter at", hint: "0; a phase 0…1, or match", proposals: ["match", "0"] })}
        ${formField(action, { label: "action", hint: "none", proposals: [...actions] })}
        ${newAlternative(fields, layer, place, cell)}`
  }`;
}
