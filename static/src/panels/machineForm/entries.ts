/** Lists the entries of a section of the machine: each has a name, fields, and buttons to move and delete it. */

import { html, nothing, type TemplateResult } from "lit-html";
import { repeat } from "lit-html/directives/repeat.js";
import type { Operation } from "../../net/protocol";
import type { EditingFields, Means } from "../../state/editingFields";
import { type FieldLook, formField } from "../../ui/formField";

export interface EntryField extends FieldLook {
  value: string;
  means: Means;
}

/** An entry of a section; what an entry does not offer is left out. */
export interface Entry {
  name: string;
  rename?: Means;
  fields: readonly EntryField[];
  /** Moves the entry before the one above it. */
  earlier?: readonly Operation[];
  remove?: readonly Operation[];
}

export interface Section {
  title: string;
  entries: readonly Entry[];
  /** The field that adds an entry. */
  add?: { hint: string; means: Means };
}

export function sectionForm(fields: EditingFields, section: Section): TemplateResult {
  const { title, entries, add } = section;
  const added = add && fields.bind(`${title} new`, "", (text) => add.means(text.trim()));
  return html`<details data-section=${title}>
    <summary>
      <span .textContent=${title}></span>
      <output .textContent=${add ? String(entries.length) : ""}></output>
    </summary>
    ${repeat(
      entries,
      ({ name }) => name,
      (entry) => entryForm(fields, title, entry),
    )}
    ${added ? formField(added, { label: "new", hint: add.hint }) : nothing}
  </details>`;
}

function entryForm(fields: EditingFields, title: string, entry: Entry): TemplateResult {
  const { name, rename, earlier, remove } = entry;
  const rows = entry.fields.map(({ value, means, ...look }) =>
    formField(fields.bind(`${title} ${name} ${look.label}`, value, means), look),
  );
  if (!rename && !remove) return html`${rows}`;
  const own = rename && fields.bind(`${title} ${name} name`, name, (text) => rename(text.trim()));
  return html`<fieldset aria-label=${name}>
    ${own ? formField(own, { label: "name" }) : html`<b class="entry-name" .textContent=${name}></b>`} ${rows}
    <p class="buttons">
      ${earlier ? act(fields, `${title} ${name} earlier`, `move ${name} up`, "up", earlier) : nothing}
      ${remove ? act(fields, `${title} ${name} delete`, `delete ${name}`, "delete", remove) : nothing}
    </p>
  </fieldset>`;
}

/** Draws a button that makes an edit; a refusal stands below it. */
export function act(
  fields: EditingFields,
  key: string,
  label: string,
  words: string,
  operations: readonly Operation[],
): TemplateResult {
  const field = fields.bind(key, "", () => operations);
  return html`<button
      type="button"
      aria-label=${label}
      .textContent=${words}
      @click=${() => field.left(words)}
    ></button>
    <span class="field-error" role="status" ?hidden=${!field.error} .textContent=${field.error}></span>`;
}

/** Returns the operation that moves an entry up, by the name before it; nothing for the first. */
export function movedUp(
  entries: readonly { name: string }[],
  at: number,
  operation: (before: string) => Operation,
): { earlier?: Operation[] } {
  const before = entries[at - 1]?.name;
  return before === undefined ? {} : { earlier: [operation(before)] };
}
