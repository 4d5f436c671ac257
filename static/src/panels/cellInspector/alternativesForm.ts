/** The alternatives of a cell: next states with their conditions, or with their weights. */

import { html, nothing, type TemplateResult } from "lit-html";
import type { Cell, LayerInfo, Operation } from "../../net/protocol";
import type { CellPlace } from "../../state/editAnswer";
import type { EditingFields } from "../../state/editingFields";
import { formField } from "../../ui/formField";
import { type AlternativeText, alternativeTexts, setAlternatives, targetText } from "./cellValues";
import { transitionFields } from "./transitionFields";

export function alternativesForm(
  fields: EditingFields,
  layer: LayerInfo,
  place: CellPlace,
  cell: Cell,
  actions: readonly string[],
): TemplateResult {
  const texts = alternativeTexts(cell);
  const states = layer.states.flatMap(({ name }) => [name, `${name}!`]);
  const keep = (next: readonly AlternativeText[]) => setAlternatives(place, cell, next);
  const form = { fields, states, actions, cell, texts, keep };
  return html`<fieldset class="alternatives">
    <legend>
      ${texts.some(({ weight }) => weight) ? "one of these, by chance" : "the first that is true"}
    </legend>
    ${texts.map((text, i) => alternative(form, text, i))} ${newAlternative(fields, layer, place, cell)}
  </fieldset>`;
}

interface Form {
  fields: EditingFields;
  states: readonly string[];
  actions: readonly string[];
  cell: Cell;
  texts: readonly AlternativeText[];
  keep: (next: readonly AlternativeText[]) => Operation[];
}

function alternative(form: Form, text: AlternativeText, i: number): TemplateResult {
  const { fields, states, texts, keep } = form;
  const replaced = (part: Partial<AlternativeText>) =>
    keep(texts.map((other, at) => (at === i ? { ...other, ...part } : other)));
  const to = fields.bind(`to ${i}`, text.to, (value) => replaced({ to: value }));
  const weight = fields.bind(`weight ${i}`, text.weight, (value) =>
    replaced({ weight: value, condition: "" }),
  );
  return html`<div class="alternative" role="group" aria-label=${`alternative ${i + 1}`}>
    ${formField(to, { label: "to", choices: states.map((state) => [state, state] as const) })}
    ${text.weight ? formField(weight, { label: "weight", number: true }) : conditional(form, text, i, replaced)}
    ${buttons(form, text, i)}
  </div>`;
}

/** Draws the fields of an alternative that has no weight: its condition, and its own transition. */
function conditional(
  { fields, actions, cell }: Form,
  text: AlternativeText,
  i: number,
  replaced: (part: Partial<AlternativeText>) => Operation[],
): TemplateResult {
  const condition = fields.bind(`if ${i}`, text.condition, (value) =>
    replaced({ condition: value, weight: "" }),
  );
  return html`${formField(condition, { label: "if", hint: i ? "otherwise" : "stamina > 10" })}
  ${transitionFields(fields, ` ${i}`, text, cell, actions, (change) =>
    replaced({
      blend: change.blend ?? text.blend,
      curve: change.curve ?? text.curve,
      enter: "enter" in change ? (change.enter ?? cell.enter) : text.enter,
      action: "action" in change ? (change.action ?? cell.action) : text.action,
    }),
  )}`;
}

function buttons({ fields, texts, keep }: Form, text: AlternativeText, i: number): TemplateResult {
  const act = (key: string, next: readonly AlternativeText[]): (() => void) => {
    const field = fields.bind(key, "", () => keep(next));
    return () => field.left(JSON.stringify(next));
  };
  const without = texts.filter((_, at) => at !== i);
  const earlier = [...texts.slice(0, i - 1), text, texts[i - 1]!, ...texts.slice(i + 1)];
  return html`<p class="buttons">
    ${
      i && !text.weight
        ? html`<button type="button" @click=${act(`order ${i}`, earlier)}>earlier</button>`
        : nothing
    }
    <button type="button" aria-label=${`delete ${text.to}`} @click=${act(`without ${i}`, without)}>
      delete
    </button>
  </p>`;
}

/** The fields that give a cell its first, or one more, condition or chance. */
export function newAlternative(
  fields: EditingFields,
  layer: LayerInfo,
  place: CellPlace,
  cell: Cell,
): TemplateResult {
  const { blend, curve, enter, action } = cell;
  const only = { to: targetText(cell), condition: "", weight: "", blend, curve, enter, action };
  const texts = cell.alternatives.length ? alternativeTexts(cell) : [only];
  const to = layer.states.find(({ name }) => !texts.some((text) => text.to === name))?.name ?? place.state;
  const condition = fields.bind("new if", "", (text) =>
    setAlternatives(place, cell, [{ ...only, to, condition: text }, ...texts]),
  );
  const chance = fields.bind("new chance", "", () =>
    setAlternatives(place, cell, [...texts, { ...only, to, weight: "1" }]),
  );
  const byChance = texts.some(({ weight }) => weight);
  const byCondition = texts.some(({ condition: words }) => words);
  return html`${byChance ? nothing : formField(condition, { label: "new: if", hint: "stamina > 10" })}
  ${
    byCondition
      ? nothing
      : html`<button type="button" class="wide" @click=${() => chance.left("one")}>add a chance</button>
          <p class="field-error" ?hidden=${!chance.error} .textContent=${chance.error}></p>`
  }`;
}
