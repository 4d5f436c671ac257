/** The last step of an import: which clip is which state, beside the picture of the character. */

import * as api from "../../net/api";
import * as machines from "../../net/machines";
import type { Mapping, UploadedCharacter } from "../../net/protocol";
import { reasonOf } from "../../net/reason";
import { plural } from "../../ui/amounts";
import { el, say } from "../../ui/dom";
import type { FrameSwitch } from "./frameSwitch";
import type { Look } from "./look";
import { MappingForm } from "./mappingForm";

export class MappingStep {
  readonly title: string;
  readonly parts: readonly Node[];
  private readonly form: MappingForm;
  private readonly name = el("input", {
    type: "text",
    id: "import-name",
    maxlength: 64,
    spellcheck: "false",
    autocomplete: "off",
  });
  private readonly wrong = el("p", { class: "import-wrong", role: "alert" });
  private readonly go = el("button", { type: "submit", class: "primary" }, "Make a machine");

  /** `made` gets the name of the new machine. */
  constructor(
    private readonly character: UploadedCharacter,
    mapping: Mapping,
    look: Look,
    private readonly frames: FrameSwitch | null,
    private readonly signal: AbortSignal,
    private readonly made: (machine: string) => Promise<void>,
  ) {
    this.form = new MappingForm(mapping, (clip) => look.playButton(clip));
    this.title = character.clips ? "Which clip is which state?" : "A model without animations";
    this.name.value = character.name;
    const all = el("div", { class: "look" }, look.picture, this.formOf(look));
    this.parts = [el("p", { class: "import-about" }, this.summary()), all];
  }

  focus(): void {
    this.go.focus();
  }

  private summary(): string {
    const { clips, joints, vertices } = this.character;
    return [plural(clips, "clip"), plural(joints, "joint"), plural(vertices, "vertex", "vertices")].join(
      " · ",
    );
  }

  private formOf(look: Look): HTMLFormElement {
    const states = this.character.clips
      ? this.form.element
      : el("p", {}, "Its machine gets one state, STAT: the pose at rest, which expressions can move.");
    const list = el("div", { class: "look-list" }, look.contents, states);
    const foot = el(
      "div",
      { class: "import-foot" },
      el("label", { for: this.name.id }, "name"),
      this.name,
      el("span", { class: "space" }),
      this.go,
    );
    const choice = this.frames ? [this.frames.element] : [];
    const all = el("form", { class: "import-form", novalidate: true }, list, ...choice, this.wrong, foot);
    all.addEventListener("submit", (submit) => {
      submit.preventDefault();
      void this.make();
    });
    return all;
  }

  private async make(): Promise<void> {
    const machine = this.name.value.trim();
    this.go.disabled = true;
    say(this.wrong, "");
    try {
      await this.frames?.apply(this.character.name, this.signal);
      await machines.fromCharacter(machine, this.character.name, this.form.states());
      await this.made(machine);
    } catch (error) {
      this.blame(error);
    } finally {
      this.go.disabled = false;
    }
  }

  /** Shows each error beside its input, other errors below the form. */
  private blame(error: unknown): void {
    const places = error instanceof api.ApiError ? error.places : [];
    const placed = places.map(({ field, message }) => this.form.refuse(field, message)).some(Boolean);
    if (!placed) say(this.wrong, reasonOf(error));
    if (places.some(({ field }) => field === "name")) this.name.focus();
  }
}
