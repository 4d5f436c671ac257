/** The fields of a transition: how long it blends and along which curve, where the next motion begins, its action. */

import { html, type TemplateResult } from "lit-html";
import type { Cell, MachineInfo, Operation } from "../../net/protocol";
import type { EditingFields } from "../../state/editingFields";
import { numberText } from "../../state/fieldTexts";
import { formField } from "../../ui/formField";
import { curveChoice } from "./blendCurve";
import { enterField, seconds, type Transition, type TransitionChange } from "./cellValues";

/** Where a motion begins, and what comes out, if a cell does not say it. */
export const PLAIN: Pick<Transition, "enter" | "action"> = { enter: 0, action: null };

/** `without`: what counts for a blank field; `key` tells the fields of several transitions apart. */
export function transitionFields(
  fields: EditingFields,
  key: string,
  own: Transition,
  without: Pick<Transition, "enter" | "action">,
  actions: readonly string[],
  set: (change: TransitionChange) => Operation[],
): TemplateResult {
  const blend = fields.bind(`blend${key}`, numberText(own.blend), (text) => set({ blend: seconds(text) }));
  const curve = fields.bind(`curve${key}`, own.curve, (text) => set({ curve: text as Cell["curve"] }));
  const enterText = own.enter === without.enter ? "" : String(own.enter);
  const enter = fields.bind(`enter${key}`, enterText, (text) => set({ enter: enterField(text) ?? null }));
  const actionText = own.action === without.action ? "" : (own.action ?? "");
  const action = fields.bind(`action${key}`, actionText, (text) => set({ action: text.trim() || null }));
  const enterHint = without.enter === 0 ? "0; a phase 0…1, or match" : String(without.enter);
  return html`${formField(blend, { label: "blend, s", number: true, step: 0.05 })}
  ${curveChoice(curve, own.blend)}
  ${formField(enter, { label: "enter at", hint: enterHint, proposals: ["match", "0"] })}
  ${formField(action, { label: "action", hint: without.action ?? "none", proposals: actions })}`;
}

/** Returns the actions that the machine's cells have already. */
export function actionsOf(info: MachineInfo | null): string[] {
  const cells = (info?.layers ?? []).flatMap(({ table }) =>
    Object.values(table).flatMap(Object.values<Cell>),
  );
  const all = cells.flatMap(({ action, alternatives }) => [action, ...alternatives.map((way) => way.action)]);
  return [...new Set(all.filter((action) => action !== null))];
}
