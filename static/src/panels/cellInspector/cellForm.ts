/** The form of a cell: its next state, when it fires, how it blends, and its alternatives. */

import { html, nothing, type TemplateResult } from "lit-html";
import type { Cell, LayerInfo } from "../../net/protocol";
import type { CellPlace } from "../../state/editAnswer";
import type { EditingFields } from "../../state/editingFields";
import { formField } from "../../ui/formField";
import type { App } from "../../view/app";
import { alternativesForm, newAlternative } from "./alternativesForm";
import { cellOf, isWritten, setFields, setTarget, setTransition, setWhen, targetText } from "./cellValues";
import { actionsOf, PLAIN, transitionFields } from "./transitionFields";

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
    ${source(app, cell, place)} ${target(fields, layer, place, cell, actionsOf(app.machine.info.value))}
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
  actions: readonly string[],
): TemplateResult {
  if (cell?.alternatives.length) return alternativesForm(fields, layer, place, cell, actions);
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
  const when = fields.bind("when", cell.when, (text) =>
    setWhen(place, cell, text === "window" ? "window 0.2..0.8" : text),
  );
  const [, first = "", last = ""] = /^window ([\d.]+?)\.\.([\d.]+)$/.exec(cell.when) ?? [];
  const bounds = fields.bind("window", `${first}..${last}`, (text) =>
    setFields(place, cell, { when: `window ${text}` }),
  );
  const info = machine.info.value;
  const curve = info?.defaults.curve ?? "cubic";
  return html`${formField(when, { label: "fires", choices: moments(layer, place, cell.when) })}
  ${first ? formField(bounds, { label: "window", hint: "0.2..0.8" }) : nothing}
  ${
    cell.alternatives.some(({ weight }) => weight === null)
      ? nothing
      : transitionFields(fields, "", cell, PLAIN, actionsOf(info), (change) =>
          setTransition(place, cell, change, curve),
        )
  }
  ${cell.alternatives.length ? nothing : newAlternative(fields, layer, place, cell)}`;
}
