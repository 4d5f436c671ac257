/** Imports a machine; or a character: uploads its file, maps its clips to states and makes a machine. Shows it. */

import "./importDialog.css";
import * as api from "../../net/api";
import { freeName, putCharacter, putMachine } from "../../net/upload";
import type { Mapping, UploadedCharacter } from "../../net/protocol";
import { reasonOf } from "../../net/reason";
import { size } from "../../ui/amounts";
import { el, say } from "../../ui/dom";
import { releaseFocus } from "../../ui/focus";
import type { Quality } from "../../view/quality";
import { importCapture, isCapture } from "./captureImport";
import { carriedText } from "./carriedText";
import { FrameSwitch } from "./frameSwitch";
import { checkSize, chosenFiles, type LocalFile } from "./localFiles";
import { Look } from "./look";
import { machineAmong } from "./machineFiles";
import { MappingStep } from "./mappingStep";
import { MODELS, oneFile, PARTS } from "./modelFiles";
import { offerRig } from "./rigStep";

const ACCEPT = [...MODELS, ...PARTS, ".csv", "model/gltf-binary", "application/zip"].join();

/** Of joints, in a sentence beside the character. */
const NAMES = 4;

export class ImportDialog {
  private readonly dialog = el("dialog", {
    class: "import",
    "aria-labelledby": "import-title",
    tabindex: "-1",
  });
  private readonly fileInput = el("input", {
    type: "file",
    accept: ACCEPT,
    multiple: true,
    hidden: true,
    tabindex: -1,
    "aria-hidden": "true",
  });
  private cancel = new AbortController();
  /** The uploaded character that has no machine yet. */
  private pending: string | null = null;
  private look: Look | null = null;

  /**
   * `made` gets the name of the new machine, and the state that it shall play; `carried` what is to be said
   * about a capture, and what asks how else to carry it over; `watched` returns the watched character.
   */
  constructor(
    private readonly made: (machine: string, state?: string) => Promise<void>,
    private readonly carried: (text: string, again: () => void) => void,
    private readonly watched: () => string | null,
    private readonly quality: Quality,
  ) {
    document.body.append(this.dialog, this.fileInput);
    this.dialog.addEventListener("close", () => this.forget());
    window.addEventListener("pagehide", () => this.forget());
    this.fileInput.addEventListener("change", () => {
      const files = chosenFiles(this.fileInput);
      this.fileInput.value = "";
      void this.take(files);
    });
  }

  /** Opens the file picker. */
  choose(): void {
    this.fileInput.click();
  }

  /** Takes a dropped or chosen model, capture or machine: one file, or several that belong together. */
  async take(files: readonly LocalFile[]): Promise<void> {
    if (!files.length) return;
    this.forget();
    try {
      checkSize(files);
      const machine = await machineAmong(files);
      const file = machine ?? (await oneFile(files));
      await (machine ? this.machine(file) : isCapture(file) ? this.capture(file) : this.upload(file));
    } catch (error) {
      this.refuse(error);
    }
  }

  /** Makes the machine, under its file's name or the next free one, and shows it. */
  private async machine(file: File): Promise<void> {
    const progress = this.showProgress(file, "machine");
    await this.unlessClosed(async (signal) => {
      const name = await freeName(file.name);
      await putMachine(name, file, progress, signal);
      await this.finish(name);
    });
  }

  /** Carries a capture over to the watched character; plays it at once. */
  private async capture(file: File): Promise<void> {
    const target = this.watched();
    if (target === null) {
      this.refuse("Drop a motion on a character: no character is shown yet.");
      return;
    }
    await this.carry(file, target);
  }

  /** `why` asks first which joints are which bones. */
  private async carry(file: File, target: string, why?: string): Promise<void> {
    await this.unlessClosed(async (signal) => {
      const { machine, state, report } = await importCapture(file, target, {
        progress: this.showProgress(file),
        signal,
        ask: (said, ...forms) => this.askForBones(said, forms, signal),
        ...(why === undefined ? {} : { why }),
      });
      await this.finish(machine, state);
      const all = carriedText(report, Infinity);
      this.carried(carriedText(report, NAMES), () => void this.carry(file, target, all));
    });
  }

  /** Runs a step until the dialog is closed; says why it failed. */
  private async unlessClosed(step: (signal: AbortSignal) => Promise<void>): Promise<void> {
    const { signal } = (this.cancel = new AbortController());
    try {
      await step(signal);
    } catch (error) {
      if (!signal.aborted) this.refuse(error);
    }
  }

  private async finish(machine: string, state?: string): Promise<void> {
    this.dialog.close();
    releaseFocus();
    await this.made(machine, state);
  }

  /** Shows which joint is which bone; resolves when the form is sent, rejects when the dialog is closed. */
  private askForBones(why: string, forms: readonly HTMLElement[], signal: AbortSignal): Promise<void> {
    return new Promise((resolve, reject) => {
      const go = el("button", { type: "submit", class: "primary" }, "Carry it over");
      const foot = el("div", { class: "import-foot" }, el("span", { class: "space" }), go);
      const all = el("form", { class: "import-form", novalidate: true }, ...forms, foot);
      all.addEventListener("submit", (submit) => {
        submit.preventDefault();
        go.disabled = true;
        resolve();
      });
      signal.addEventListener("abort", () => reject(new DOMException("aborted", "AbortError")));
      this.show("Which joint is which bone?", el("p", { class: "import-about", role: "status" }, why), all);
      all.querySelector<HTMLInputElement>("input[value=''], input")?.focus();
    });
  }

  private async upload(file: File): Promise<void> {
    const progress = this.showProgress(file);
    await this.unlessClosed(async (signal) => {
      const name = await freeName(file.name);
      const uploaded = await putCharacter(name, file, progress, signal);
      this.pending = name;
      const lookAt = async (): Promise<Look> => {
        const facts = await api.character(name);
        signal.throwIfAborted();
        return new Look(facts, this.quality);
      };
      const character = await offerRig(uploaded, lookAt, this.showLook.bind(this), signal);
      const mapping = await api.mapping(name);
      const look = await lookAt();
      this.showMapping(character, mapping, look, FrameSwitch.of(file));
    });
  }

  private show(title: string, ...parts: (Node | null)[]): void {
    this.leaveLook();
    const close = el("button", { type: "button", class: "plain close", "aria-label": "esc: close" }, "esc");
    close.addEventListener("click", () => this.dialog.close());
    this.dialog.replaceChildren(
      close,
      el("h2", { id: "import-title" }, title),
      ...parts.filter((part) => part !== null),
    );
    if (!this.dialog.open) this.dialog.showModal();
  }

  /** Shows a step with a picture, which ends when another step is shown. */
  private showLook(title: string, look: Look | null, ...parts: Node[]): void {
    this.show(title, ...parts);
    this.look = look;
  }

  private showProgress(file: File, what = "character"): (share: number) => void {
    const bar = el("progress", { max: 1, value: 0, "aria-label": "upload" });
    const words = el("span", { class: "import-share", role: "status" }, "0 %");
    const facts = el("p", { class: "import-file" }, el("b", {}, file.name), ` ${size(file.size)}`);
    this.show(`Importing your ${what}`, facts, bar, words);
    this.dialog.focus(); // the only button cancels: an Enter that comes too early must not press it
    return (share) => {
      if (share < 1) bar.value = share;
      else bar.removeAttribute("value");
      say(words, share < 1 ? `${Math.round(share * 100)} %` : "the server reads it …");
    };
  }

  private refuse(error: unknown): void {
    const reason = reasonOf(error);
    const places =
      error instanceof api.ApiError
        ? error.places.map(({ field }) => field).filter((field) => field && !reason.includes(field))
        : [];
    const place = places.length
      ? el("p", { class: "import-place" }, "at ", el("code", {}, places.join(", ")))
      : null;
    const again = el("button", { type: "button", class: "primary" }, "Choose another file…");
    again.addEventListener("click", () => this.choose());
    const why = el("div", { class: "import-reason", role: "alert" }, el("p", {}, reason), place);
    this.show(
      "You cannot use this file",
      why,
      el("div", { class: "import-foot" }, el("span", { class: "space" }), again),
    );
    again.focus();
  }

  /** Shows the character beside the form that makes its machine. */
  private showMapping(
    character: UploadedCharacter,
    mapping: Mapping,
    look: Look,
    frames: FrameSwitch | null,
  ): void {
    const step = new MappingStep(character, mapping, look, frames, this.cancel.signal, async (machine) => {
      this.pending = null;
      await this.finish(machine);
    });
    this.showLook(step.title, look, ...step.parts);
    step.focus();
  }

  /** Aborts the upload and removes a character without a machine from the server. */
  private forget(): void {
    this.cancel.abort();
    this.leaveLook();
    if (this.pending !== null) api.removeCharacter(this.pending).catch(() => undefined);
    this.pending = null;
  }

  private leaveLook(): void {
    this.look?.end();
    this.look = null;
  }
}
