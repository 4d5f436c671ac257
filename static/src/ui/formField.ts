/** Draws a field of a form: label, control, and what is wrong with it. */

import "./formField.css";
import { html, nothing, type TemplateResult } from "lit-html";
import { live } from "lit-html/directives/live.js";

/** The part of a field that comes and goes with what is typed. */
interface Typing {
  key: string;
  value: string;
  error: string;
  /** Whether the value is typed and not kept. */
  changed: boolean;
  typed: (text: string) => void;
  left: (text: string) => void;
  dropped: () => void;
}

export interface FieldLook {
  label: string;
  /** The texts that can be chosen, each with its words; without them the field is typed in. */
  choices?: readonly (readonly [string, string])[];
  /** Texts that are proposed. */
  proposals?: readonly string[];
  hint?: string;
  number?: boolean;
  step?: number;
  lines?: number;
}

const textOf = ({ target }: Event): string => (target as HTMLInputElement).value;

/** Draws a field; a text is given up by Escape. */
export function formField(typing: Typing, look: FieldLook): TemplateResult {
  const id = `field-${typing.key.replace(/\W+/g, "-")}`;
  return html`<div class="field">
    <label for=${id} .textContent=${look.label}></label>
    ${look.choices ? chooser(id, typing, look.choices) : entry(id, typing, look)}
    <p
      class="field-error"
      id=${`${id}-error`}
      role="status"
      ?hidden=${!typing.error}
      .textContent=${typing.error}
    ></p>
  </div>`;
}

function chooser(
  id: string,
  { value, error, left }: Typing,
  choices: NonNullable<FieldLook["choices"]>,
): TemplateResult {
  const all = choices.some(([text]) => text === value) ? choices : [...choices, [value, value] as const];
  return html`<select
    id=${id}
    aria-invalid=${error ? "true" : nothing}
    aria-describedby=${`${id}-error`}
    @change=${(change: Event) => left(textOf(change))}
  >
    ${all.map(
      ([text, words]) =>
        html`<option value=${text} .selected=${live(text === value)} .textContent=${words || " "}></option>`,
    )}
  </select>`;
}

function entry(id: string, typing: Typing, look: FieldLook): TemplateResult {
  const { value, error, changed, typed, left, dropped } = typing;
  const pressed = (press: KeyboardEvent): void => {
    if (press.key === "Enter" && !(look.lines && press.shiftKey)) {
      press.preventDefault();
      left(textOf(press));
    } else if (press.key === "Escape" && changed) {
      press.preventDefault();
      dropped();
    }
  };
  const common = {
    input: (change: Event) => typed(textOf(change)),
    change: (change: Event) => left(textOf(change)),
  };
  if (look.lines)
    return html`<textarea
      id=${id}
      rows=${look.lines}
      spellcheck="false"
      placeholder=${look.hint ?? nothing}
      aria-invalid=${error ? "true" : nothing}
      aria-describedby=${`${id}-error`}
      .value=${live(value)}
      @input=${common.input}
      @change=${common.change}
      @keydown=${pressed}
    ></textarea>`;
  return html`<input
      id=${id}
      type=${look.number ? "number" : "text"}
      step=${look.step ?? "any"}
      list=${look.proposals ? `${id}-list` : nothing}
      spellcheck="false"
      autocomplete="off"
      placeholder=${look.hint ?? nothing}
      aria-invalid=${error ? "true" : nothing}
      aria-describedby=${`${id}-error`}
      .value=${live(value)}
      @input=${common.input}
      @change=${common.change}
      @keydown=${pressed}
    />${
      look.proposals
        ? html`<datalist id=${`${id}-list`}>
            ${look.proposals.map((text) => html`<option value=${text}></option>`)}
          </datalist>`
        : nothing
    }`;
}
