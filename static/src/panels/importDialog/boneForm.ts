/**
 * The form that says which joint is which bone, for a capture and the character that it is carried over to. Names
 * of joints come from files of strangers, so they are set as text.
 */

import "./mappingForm.css";
import { html, type TemplateResult } from "lit-html";
import type { Bones } from "../../net/protocol";

/** One of the two skeletons. */
export interface Skeleton {
  /** What a carried clip calls its bones. */
  key: "bones" | "target_bones";
  title: string;
  bones: Bones;
  joints: string[];
}

/** `LeftUpperLeg` -> `left upper leg`. */
export const wordsOf = (bone: string): string => bone.replace(/(?!^)[A-Z]/g, " $&").toLowerCase();

/** Returns whether a bone that is needed has no joint yet. */
export const lacksJoints = ({ bones }: Skeleton): boolean =>
  bones.needed.some((bone) => !(bone in bones.bones));

function field(bone: string, { key, title, bones }: Skeleton): TemplateResult {
  return html`<input
    type="text"
    name=${`${key} ${bone}`}
    list=${`joints-${key}`}
    maxlength="200"
    spellcheck="false"
    autocomplete="off"
    placeholder="none"
    aria-label=${`${wordsOf(bone)}: ${title}`}
    .defaultValue=${bones.bones[bone] ?? ""}
  />`;
}

const list = ({ key, joints }: Skeleton): TemplateResult =>
  html`<datalist id=${`joints-${key}`}>
    ${joints.map((joint) => html`<option value=${joint}></option>`)}
  </datalist>`;

export function boneForm(source: Skeleton, target: Skeleton): TemplateResult {
  const { needed, known } = source.bones;
  const row = (bone: string): TemplateResult =>
    html`<div class="map-row bone-row">
      <span class="map-clip" .textContent=${wordsOf(bone)}></span>
      ${field(bone, source)} ${field(bone, target)}
    </div>`;
  return html`<div class="map">
    <div class="map-row bone-row map-head" aria-hidden="true">
      <span>bone</span><span>${source.title}</span><span>${target.title}</span>
    </div>
    ${needed.map(row)}
    <details class="more-bones">
      <summary>arms, spine, head and fingers</summary>
      ${known.filter((bone) => !needed.includes(bone)).map(row)}
    </details>
    ${list(source)} ${list(target)}
  </div>`;
}

/** Returns the joints that differ from what the names told; "": the bone has none. */
export function chosenJoints(fields: FormData, { key, bones }: Skeleton): Record<string, string> {
  const chosen = bones.known.flatMap((bone) => {
    const joint = fields.get(`${key} ${bone}`);
    return typeof joint === "string" ? [[bone, joint.trim()] as const] : [];
  });
  return Object.fromEntries(chosen.filter(([bone, joint]) => joint !== (bones.bones[bone] ?? "")));
}
