/** Offers a skeleton and a skin for a dropped mesh that has neither skin nor animations, beside its picture. */

import "./rigStep.css";
import * as api from "../../net/api";
import type { UploadedCharacter } from "../../net/protocol";
import type { NewRig } from "../../net/types/api.generated";
import { el } from "../../ui/dom";
import type { Look } from "./look";

/** Shows a step of the dialog, which ends `look` with the next step. */
type Show = (title: string, look: Look | null, ...parts: HTMLElement[]) => void;
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

function choices<Key extends string>(
  id: string,
  label: string,
  texts: Record<Key, string>,
): [HTMLElement, () => Key] {
  const options = Object.entries<string>(texts).map(([value, text]) => el("option", { value }, text));
  const select = el("select", { id }, ...options);
  const row = el("div", { class: "rig-row" }, el("label", { for: id }, label), select);
  return [row, () => select.value as Key];
}

/** Shows the form; resolves with the choice, or null to leave the mesh as it is. */
function asked(show: Show, look: Look, wrong: string, signal: AbortSignal): Promise<Choice | null> {
  return new Promise((resolve, reject) => {
    const [skeletons, skeleton] = choices("rig-skeleton", "it is", SKELETONS);
    const [facings, facing] = choices("rig-facing", "it looks along", FACINGS);
    const plain = el("button", { type: "button" }, "Leave it as it is");
    const go = el("button", { type: "submit", class: "primary" }, "Rig it");
    const foot = el("div", { class: "import-foot" }, el("span", { class: "space" }), plain, go);
    const why = el("p", { class: "import-wrong", role: "alert" }, wrong);
    const list = el("div", { class: "look-list" }, look.contents, skeletons, facings);
    const form = el("form", { class: "import-form" }, list, why, foot);
    form.addEventListener("submit", (submit) => {
      submit.preventDefault();
      resolve({ skeleton: skeleton(), facing: facing() });
    });
    plain.addEventListener("click", () => resolve(null));
    signal.addEventListener("abort", () => reject(new DOMException("aborted", "AbortError")));
    const about = "The model has no skin and no animations. statwalk can give it a skeleton that bends it.";
    const all = el("div", { class: "look" }, look.picture, form);
    show("Give it a skeleton?", look, el("p", { class: "import-about" }, about), all);
    go.focus();
  });
}

/** Returns the character, rigged if somebody wants it; asks only for a mesh without skin and animations. */
export async function offerRig(
  character: UploadedCharacter,
  lookAt: () => Promise<Look>,
  show: Show,
  signal: AbortSignal,
): Promise<UploadedCharacter> {
  if (character.skins || character.clips || !character.vertices) return character;
  for (let wrong = ""; ;) {
    const choice = await asked(show, await lookAt(), wrong, signal);
    if (choice === null) return character;
    const busy = el("progress", { "aria-label": "rigging" });
    show(
      "Rigging your character",
      null,
      el("p", { role: "status" }, "The server places joints and weights …"),
      busy,
    );
    try {
      return await api.rig(character.name, choice, signal);
    } catch (error) {
      if (!(error instanceof api.ApiError) || error.status !== 422) throw error;
      wrong = error.message;
    }
  }
}
