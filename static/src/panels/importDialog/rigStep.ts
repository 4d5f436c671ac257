/** Offers a skeleton and a skin for a dropped mesh that has neither skin nor animations, beside its picture. */

import "./rigStep.css";
import { html, type TemplateResult } from "lit-html";
import * as api from "../../net/api";
import type { UploadedCharacter } from "../../net/protocol";
import type { NewRig } from "../../net/types/api.generated";
import type { Look } from "./look";
import { asked, type Step } from "./step";

type Choice = Required<Pick<NewRig, "skeleton" | "facing">>;

const SKELETONS: Record<Choice["skeleton"], string> = {
  human: "a human, standing",
  mammal: "an animal on four legs",
  parts: "anything: found in the mesh",
  own: "the joints in the file",
};
const FACINGS: Record<Choice["facing"], string> = {
  "+z": "+Z, as glTF says",
  "-z": "-Z",
  "+x": "+X",
  "-x": "-X",
};

const BUSY: Step = {
  title: "Rigging your character",
  content: () =>
    html`<p role="status">The server places joints and weights …</p>
      <progress aria-label="rigging"></progress>`,
};

function choice(name: keyof Choice, label: string, texts: Record<string, string>): TemplateResult {
  const id = `rig-${name}`;
  return html`<div class="rig-row">
    <label for=${id}>${label}</label>
    <select id=${id} name=${name}>
      ${Object.entries(texts).map(([value, text]) => html`<option value=${value}>${text}</option>`)}
    </select>
  </div>`;
}

/** The form; `answer` gets its fields, or null to leave the mesh as it is. */
const rigForm = (look: Look, wrong: string, answer: (fields: FormData | null) => void): Step => ({
  title: "Give it a skeleton?",
  look,
  focus: ".primary",
  sent: answer,
  content: () =>
    html`<p class="import-about">
        The model has no skin and no animations. statwalk can give it a skeleton that bends it.
      </p>
      <div class="look">
        ${look.picture}
        <form class="import-form">
          <div class="look-list">
            ${look.contents} ${choice("skeleton", "it is", SKELETONS)}
            ${choice("facing", "it looks along", FACINGS)}
          </div>
          <p class="import-wrong" role="alert" .textContent=${wrong}></p>
          <div class="import-foot">
            <span class="space"></span>
            <button type="button" @click=${() => answer(null)}>Leave it as it is</button>
            <button type="submit" class="primary">Rig it</button>
          </div>
        </form>
      </div>`,
});

/** Returns the character, rigged if somebody wants it; asks only for a mesh without skin and animations. */
export async function offerRig(
  character: UploadedCharacter,
  lookAt: () => Promise<Look>,
  show: (step: Step) => void,
  signal: AbortSignal,
): Promise<UploadedCharacter> {
  if (character.skins || character.clips || !character.vertices) return character;
  for (let wrong = ""; ;) {
    const look = await lookAt();
    const fields = await asked<FormData | null>(signal, (answer) => show(rigForm(look, wrong, answer)));
    if (fields === null) return character;
    show(BUSY);
    try {
      return await api.rig(character.name, Object.fromEntries(fields), signal);
    } catch (error) {
      if (!(error instanceof api.ApiError) || error.status !== 422) throw error;
      wrong = error.message;
    }
  }
}
