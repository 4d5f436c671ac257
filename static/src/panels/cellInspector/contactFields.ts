/** The fields that say when each foot stands in the clips of a state, folded. */

import { html, type TemplateResult } from "lit-html";
import { repeat } from "lit-html/directives/repeat.js";
import type { StateInfo } from "../../net/protocol";
import type { ClipContactsView } from "../../net/types/api.generated";
import type { EditingFields } from "../../state/editingFields";
import type { FootContacts } from "../../state/footContacts";
import { formField } from "../../ui/formField";
import { spansOf, spansText } from "./contactTexts";

export function contactFields(
  fields: EditingFields,
  contacts: FootContacts,
  { motion, clips }: StateInfo,
): TemplateResult {
  const known = (clips.length ? clips : [motion]).flatMap((clip) => contacts.of(clip) ?? []);
  return html`${repeat(
    known.filter(({ feet }) => feet.length),
    ({ clip }) => clip,
    (clip) => clipFields(fields, clip),
  )}`;
}

function clipFields(fields: EditingFields, { clip, feet }: ClipContactsView): TemplateResult {
  const row = ({ foot, planted }: (typeof feet)[number]): TemplateResult => {
    const field = fields.bind(`${clip} feet ${foot}`, spansText(planted), (text) => [
      { kind: "set_contacts", clip, foot, spans: spansOf(text) },
    ]);
    return formField(field, { label: foot, hint: "stands at; blank: as found" });
  };
  return html`<details class="markers">
    <summary .textContent=${`when feet stand in ${clip}`}></summary>
    ${repeat(feet, ({ foot }) => foot, row)}
  </details>`;
}
