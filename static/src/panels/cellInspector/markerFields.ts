/** The fields of markers: of a state's motion, or of one clip of its blend. A new name counts in the whole machine. */

import { html, type TemplateResult } from "lit-html";
import { repeat } from "lit-html/directives/repeat.js";
import type { Marker, Operation } from "../../net/protocol";
import type { EditingFields } from "../../state/editingFields";
import { numberText } from "../../state/fieldTexts";
import { formField } from "../../ui/formField";
import { newMarker, phase } from "./markerTexts";

/** `clip`: of a blend; "": the markers are the state's. */
export function markerFields(
  fields: EditingFields,
  state: { state: string; layer: string },
  clip: string,
  markers: readonly Marker[],
): TemplateResult {
  const set = (marker: string, at: number | null): Operation[] => [
    { kind: "set_marker", ...state, ...(clip && { clip }), marker, phase: at },
  ];
  const added = fields.bind(`${clip} new marker`, "", (text) => {
    const { name, at } = newMarker(text);
    return set(name, at);
  });
  return html`${repeat(
    markers,
    ({ name }) => name,
    (marker) => markerRow(fields, clip, marker, set),
  )}
  ${formField(added, { label: "new", hint: "left-down 0.25" })}`;
}

/** Draws the name and the phase of a marker; the phase alone, if the clip has the marker and the machine does not. */
function markerRow(
  fields: EditingFields,
  clip: string,
  { name, phase: at, written }: Marker,
  set: (marker: string, at: number | null) => Operation[],
): TemplateResult {
  const key = `${clip} marker ${name}`;
  const place = fields.bind(key, numberText(at), (text) => set(name, phase(text)));
  if (!written) return formField(place, { label: name, hint: "0…1" });
  const renamed = fields.bind(`${key} name`, name, (to) => [
    { kind: "rename_event", event: name, to: to.trim() },
  ]);
  return html`<div class="marker" role="group" aria-label=${`marker ${name}`}>
    ${formField(renamed, { label: "marker" })}
    ${formField(place, { label: "phase", hint: "0…1; blank deletes it" })}
  </div>`;
}
