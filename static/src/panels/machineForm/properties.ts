/** The section of properties: what must be true of the table, and whether it is proved. */

import { html, nothing, type TemplateResult } from "lit-html";
import { repeat } from "lit-html/directives/repeat.js";
import type { Finding, MachineInfo } from "../../net/protocol";
import type { BoundField, EditingFields } from "../../state/editingFields";
import { formField } from "../../ui/formField";
import type { App } from "../../view/app";
import { playCounterexample } from "./counterexample";

const HINTS =
  "JUMP only after WALK · never A -> B · A leads to B within 2 s · from A, EVENT reaches B within 2 s";

/** What the verifier says of a property. */
export interface Verdict {
  kind: "proved" | "refuted" | "not understood" | "undecided";
  words: string;
  finding: Finding;
}

/** Finds the verdict about a property; null: the verifier has not said anything yet. */
export function verdictOf(text: string, findings: readonly Finding[]): Verdict | null {
  const finding = findings.find(
    ({ kind, message }) => kind === "property" && message.startsWith(`${text.trim()}: `),
  );
  if (!finding) return null;
  const words = finding.message.slice(text.trim().length + 2);
  const kind =
    (["proved", "refuted", "not understood"] as const).find((name) => words.startsWith(name)) ?? "undecided";
  return { kind, words, finding };
}

export function propertyForm(app: App, fields: EditingFields, info: MachineInfo): TemplateResult {
  const { properties } = info;
  const verdicts = properties.map((text) => verdictOf(text, app.editing.findings.value));
  const proved = verdicts.filter((verdict) => verdict?.kind === "proved").length;
  const added = fields.bind("properties new", "", (text) => [{ kind: "add_property", text: text.trim() }]);
  return html`<details data-section="properties">
    <summary>
      <span>properties</span>
      <output .textContent=${properties.length ? `${proved} of ${properties.length} proved` : "0"}></output>
    </summary>
    ${repeat(
      properties,
      (text) => text,
      (text, i) => propertyEntry(app, fields, info, text, verdicts[i] ?? null),
    )}
    ${propertyField(app, info.name, added, "new", added.value)}
    <p class="hint" .textContent=${HINTS}></p>
  </details>`;
}

function propertyEntry(
  app: App,
  fields: EditingFields,
  { name, properties }: MachineInfo,
  property: string,
  verdict: Verdict | null,
): TemplateResult {
  const field = fields.bind(`properties ${property}`, property, (text) => [
    { kind: "set_property", property, text: text.trim() },
  ]);
  const drop = fields.bind(`properties ${property} delete`, "", () => [
    { kind: "set_property", property, text: null },
  ]);
  const label = String(properties.indexOf(property) + 1);
  return html`<fieldset aria-label=${property} data-verdict=${verdict?.kind ?? nothing}>
    ${propertyField(app, name, field, label, field.value)}
    ${field.changed ? nothing : verdictLine(app, name, verdict)}
    <p class="buttons">
      <button type="button" aria-label=${`delete ${property}`} @click=${() => drop.left("delete")}>
        delete
      </button>
    </p>
  </fieldset>`;
}

/** Draws the text of a property; what refutes a typed one can be played. */
function propertyField(
  app: App,
  machine: string,
  field: BoundField,
  label: string,
  text: string,
): TemplateResult {
  const refuted = field.changed ? verdictOf(text, field.findings) : null;
  return html`${formField(field, { label, hint: "JUMP only after WALK", lines: 2 })}
  ${field.checking && !field.error ? html`<p class="verdict" role="status">checking …</p>` : nothing}
  ${refuted ? replayButton(app, machine, refuted.finding) : nothing}`;
}

function verdictLine(app: App, machine: string, verdict: Verdict | null): TemplateResult {
  return html`<p class="verdict" role="status" .textContent=${verdict?.words ?? "…"}></p>
    ${verdict ? replayButton(app, machine, verdict.finding) : nothing}`;
}

function replayButton(app: App, machine: string, finding: Finding): TemplateResult {
  if (!finding.replay.length) return html``;
  const play = (): void => void playCounterexample(app, machine, finding);
  return html`<p class="buttons">
    <button type="button" @click=${play}>play what refutes it</button>
  </p>`;
}
