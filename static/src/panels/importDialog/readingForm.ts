/** How a capture is read: what its positions mean, and what is taken out of its motion. */

import { putCharacter } from "../../net/upload";
import { el } from "../../ui/dom";

/** Hz, as the server allows. */
const HIGHEST = 1000;

export class ReadingForm {
  readonly element: HTMLElement;
  private readonly added = el("input", { type: "checkbox" });
  private readonly spikes = el("input", { type: "checkbox" });
  private readonly lowPass = el("input", {
    type: "number",
    min: 0,
    max: HIGHEST,
    step: "any",
    placeholder: "none",
    "aria-label": "low-pass filter, Hz",
  });
  private isAdded = false;

  constructor(private readonly file: File) {
    const isBvh = /\.bvh$/i.test(file.name);
    this.element = el(
      "div",
      { class: "reading-form" },
      isBvh ? el("label", {}, this.added, "add positions to the offsets of joints") : null,
      el("label", {}, this.spikes, "take spikes out"),
      el("label", {}, "low-pass", this.lowPass, "Hz"),
    );
  }

  /** Uploads the capture again if its positions shall be read in another way than they were. */
  async apply(source: string, signal: AbortSignal): Promise<void> {
    if (this.added.checked === this.isAdded) return;
    const position = this.added.checked ? "add" : "replace";
    await putCharacter(source, this.file, () => undefined, signal, { position });
    this.isAdded = this.added.checked;
  }

  filter(): { low_pass: number; spikes: boolean } {
    return { low_pass: Number(this.lowPass.value) || 0, spikes: this.spikes.checked };
  }
}
