/** Imports a machine; or a character: uploads its file, maps its clips to states and makes a machine. Shows it. */

import "./importDialog.css";
import { signal } from "@preact/signals-core";
import { html, nothing } from "lit-html";
import * as api from "../../net/api";
import { freeName, putCharacter, putMachine } from "../../net/upload";
import { reasonOf } from "../../net/reason";
import { size } from "../../ui/amounts";
import { closeButton } from "../../ui/closeButton";
import { el } from "../../ui/dom";
import { draw } from "../../ui/draw";
import { releaseFocus } from "../../ui/focus";
import type { Quality } from "../../view/quality";
import { importCapture, isCapture } from "./captureImport";
import { carriedText } from "./carriedText";
import { checkSize, chosenFiles, type LocalFile } from "./localFiles";
import { Look } from "./look";
import { machineAmong } from "./machineFiles";
import { mappingStep } from "./mappingStep";
import { MODELS, oneFile, PARTS } from "./modelFiles";
import { offerRig } from "./rigStep";
import type { Step } from "./step";

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
  private readonly step = signal<Step | null>(null);
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
    draw(this.dialog, () => {
      const step = this.step.value;
      if (!step) return html``;
      return html`${closeButton}
        <h2 id="import-title" .textContent=${step.title}></h2>
        ${step.content()}`;
    });
    this.dialog.addEventListener("close", () => this.forget());
    window.addEventListener("pagehide", () => this.forget());
    this.dialog.addEventListener("submit", (submit) => {
      submit.preventDefault();
      this.step.value?.sent?.(new FormData(submit.target as HTMLFormElement));
    });
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
        show: this.show.bind(this),
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
      const character = await offerRig(uploaded, lookAt, this.show.bind(this), signal);
      // The stored model has the skeleton that the server made; the dropped file has none.
      const content = character === uploaded ? file : await api.storedModel(name);
      const mapping = await api.mapping(name);
      const look = await lookAt();
      this.show(
        mappingStep(character, mapping, look, { name: file.name, content }, signal, async (machine) => {
          this.pending = null;
          await this.finish(machine);
        }),
      );
    });
  }

  private show(step: Step): void {
    this.leaveLook();
    this.look = step.look ?? null;
    this.step.value = step;
    if (!this.dialog.open) this.dialog.showModal();
    (step.focus ? this.dialog.querySelector<HTMLElement>(step.focus) : this.dialog)?.focus();
  }

  private showProgress(file: File, what = "character"): (share: number) => void {
    const share = signal(0);
    const words = (): string =>
      share.value < 1 ? `${Math.round(share.value * 100)} %` : "the server reads it …";
    // The only button cancels, and does not get the focus: an Enter that comes too early must not press it.
    this.show({
      title: `Importing your ${what}`,
      content: () =>
        html`<p class="import-file"><b .textContent=${file.name}></b> ${size(file.size)}</p>
          <progress max="1" value=${share.value < 1 ? share.value : nothing} aria-label="upload"></progress>
          <span class="import-share" role="status" .textContent=${words()}></span>`,
    });
    return (now) => void (share.value = now);
  }

  private refuse(error: unknown): void {
    const reason = reasonOf(error);
    const places =
      error instanceof api.ApiError
        ? error.places.map(({ field }) => field).filter((field) => field && !reason.includes(field))
        : [];
    this.step.value = null; // a screen reader reads an alert again only if the page draws a new one
    const place = html`<p class="import-place">at <code .textContent=${places.join(", ")}></code></p>`;
    this.show({
      title: "You cannot use this file",
      focus: ".primary",
      content: () =>
        html`<div class="import-reason" role="alert">
            <p .textContent=${reason}></p>
            ${places.length ? place : nothing}
          </div>
          <div class="import-foot">
            <span class="space"></span>
            <button type="button" class="primary" @click=${() => this.choose()}>Choose another file…</button>
          </div>`,
    });
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
