/** The alternatives of a cell: next states with their conditions, or with their weights. */

import { html, nothing, type TemplateResult } from "lit-html";
import type { Cell, LayerInfo } from "../../net/protocol";
import type { CellPlace } from "../../state/editAnswer";
import type { EditingFields } from "../../state/editingFields";
import { formField } from "../../ui/formField";
import {
  alternativeField,
  type AlternativeText,
  alternativeTexts,
  seconds,
  setAlternatives,
  setFields,
  targetText,
} from "./cellValues";

export function alternativesForm(
  fields: EditingFields,
  layer: LayerInfo,
  place: CellPlace,
  cell: Cell,
): TemplateResult {
  const texts = alternativeTexts(cell);
  const states = layer.states.flatMap(({ name }) => [name, `${name}!`]);
  const keep = (next: readonly AlternativeText[]) => setAlternatives(place, cell, next);
  const act = (key: string, next: readonly AlternativeText[]): (() => void) => {
    const field = fields.bind(key, "", () => keep(next));
    return () => field.left(JSON.stringify(next));
  };
  return html`<fieldset class="alternatives">
    <legend>the first that is true</legend>
    ${texts.map((text, i) => alternative(fields, states, texts, i, text, cell, keep, place, act))}
    ${newAlternative(fields, layer, place, cell)}
  </fieldset>`;
}

const replaced = (texts: readonly AlternativeText[], i: number, part: Partial<AlternativeText>) =>
  texts.map((text, at) => (at === i ? { ...text, ...part } : text));

function alternative(
  fields: EditingFields,
  states: readonly string[],
  texts: readonly AlternativeText[],
  i: number,
  text: AlternativeText,
  cell: Cell,
  keep: (next: readonly AlternativeText[]) => ReturnType<typeof setAlternatives>,
  place: CellPlace,
  act: (key: string, next: readonly AlternativeText[]) => () => void,
): TemplateResult {
  const to = fields.bind(`to ${i}`, text.to, (value) => keep(replaced(texts, i, { to: value })));
  const condition = fields.bind(`if ${i}`, text.condition, (value) =>
    keep(replaced(texts, i, { condition: value, weight: "" })),
  );
  const weight = fields.bind(`weight ${i}`, text.weight, (value) =>
    keep(replaced(texts, i, { weight: value, condition: "" })),
  );
  const blend = cell.alternatives[i]!.blend;
  const time = fields.bind(`blend ${i}`, String(blend), (value) =>
    setFields(place, { alternatives: withBlend(cell, i, seconds(value)) }),
  );
  const without = texts.filter((_, at) => at !== i);
  const earlier = [...texts.slice(0, i - 1), text, texts[i - 1]!, ...texts.slice(i + 1)];
  return html`<div class="alternative">
    ${formField(to, { label: "to", choices: states.map((state) => [state, state] as const) })}
    ${
      text.weight
        ? formField(weight, { label: "weight", number: true })
        : html`${formField(condition, { label: "if", hint: i ? "otherwise" : "stamina > 10" })}
          ${formField(time, { label: "blend, s", number: true, step: 0.05 })}`
    }
    <p class="buttons">
      ${
        i && !text.weight
          ? html`<button type="button" @click=${act(`order ${i}`, earlier)}>earlier</button>`
          : nothing
      }
      <button type="button" aria-label=${`delete ${text.to}`} @click=${act(`without ${i}`, without)}>
        delete
      </button>
    </p>
  </div>`;
}

function withBlend(cell: Cell, i: number, value: number) {
  return cell.alternatives.map((old, at) =>
    alternativeField(old.restart ? `${old.to}!` : old.to, old.condition, at === i ? value : old.blend, old),
  );
}

/** The fields that give a cell its first, or one more, condition or chance. */
export function newAlternative(
  fields: EditingFields,
  layer: LayerInfo,
  place: CellPlace,
  cell: Cell,
): TemplateResult {
  const texts = cell.alternatives.length
    ? alternativeTexts(cell)
    : [{ to: targetText(cell), condition: "", weight: "" }];
  const other = layer.states.find(({ name }) => !texts.some(({ to }) => to === name))?.name ?? place.state;
  const condition = fields.bind("new if", "", (text) =>
    setAlternatives(place, cell, [{ to: other, condition: text, weight: "" }, ...texts]),
  );
  const chance = fields.bind("new chance", "", () =>
    setAlternatives(place, cell, [...texts, { to: other, condition: "", weight: "1" }]),
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
