/** The last step of an import: which clip is which state, beside the picture of the character. */

import { signal } from "@preact/signals-core";
import { html, nothing } from "lit-html";
import * as api from "../../net/api";
import * as machines from "../../net/machines";
import type { Mapping, UploadedCharacter } from "../../net/protocol";
import { reasonOf } from "../../net/reason";
import { type HowToRead, putCharacter } from "../../net/upload";
import { plural } from "../../ui/amounts";
import type { Look } from "./look";
import { MappingForm } from "./mappingForm";
import type { Step } from "./step";

const frameSwitch = html`<label class="import-switch">
  <input type="checkbox" name="switched" /> switch from frame to frame
</label>`;

/** `file` is what the character was read from; `made` gets the name of the new machine. */
export function mappingStep(
  { name, clips, joints, vertices }: UploadedCharacter,
  mapping: Mapping,
  look: Look,
  file: { name: string; content: Blob },
  closed: AbortSignal,
  made: (machine: string) => Promise<void>,
): Step {
  const form = new MappingForm(mapping, (clip) => look.playButton(clip));
  const wrong = signal("");
  const isBusy = signal(false);
  let asRead = "{}";

  /** Shows each error beside its input, other errors below the form. */
  function blame(error: unknown): void {
    const places = error instanceof api.ApiError ? error.places : [];
    const placed = places.map(({ field, message }) => form.refuse(field, message)).some(Boolean);
    if (!placed) wrong.value = reasonOf(error);
    if (places.some(({ field }) => field === "name")) document.getElementById("import-name")?.focus();
  }

  /** Has the server read the file again if the user wants it read in another way than it was. */
  async function readAgain(isSwitched: boolean): Promise<void> {
    const how: HowToRead = {
      ...(isSwitched ? { inbetween: "switched" } : {}),
      ...(look.hidden.length ? { without: look.hidden } : {}),
    };
    const wanted = JSON.stringify(how);
    if (wanted === asRead) return;
    await putCharacter(name, file.content, () => undefined, closed, how);
    asRead = wanted;
  }

  async function make(fields: FormData): Promise<void> {
    const machine = (fields.get("name") as string).trim();
    isBusy.value = true;
    wrong.value = "";
    form.forgive();
    try {
      await readAgain(fields.has("switched"));
      await machines.fromCharacter(machine, name, form.states());
      await made(machine);
    } catch (error) {
      blame(error);
    } finally {
      isBusy.value = false;
    }
  }

  const facts = [plural(clips, "clip"), plural(joints, "joint"), plural(vertices, "vertex", "vertices")];
  return {
    title: clips ? "Which clip is which state?" : "A model without animations",
    look,
    focus: ".primary",
    sent: (fields) => void make(fields),
    content: () =>
      html`<p class="import-about">${facts.join(" · ")}</p>
        <div class="look">
          ${look.picture}
          <form class="import-form" novalidate>
            <div class="look-list">
              ${look.contents}
              ${
                clips
                  ? form.part()
                  : html`<p>
                      Its machine gets one state, STAT: the pose at rest, which expressions can move.
                    </p>`
              }
            </div>
            ${/\.md2$/i.test(file.name) ? frameSwitch : nothing}
            <p class="import-wrong" role="alert" .textContent=${wrong.value}></p>
            <div class="import-foot">
              <label for="import-name">name</label>
              <input
                type="text"
                id="import-name"
                name="name"
                maxlength="64"
                spellcheck="false"
                autocomplete="off"
                .value=${name}
              />
              <span class="space"></span>
              <button type="submit" class="primary" ?disabled=${isBusy.value}>Make a machine</button>
            </div>
          </form>
        </div>`,
  };
}
