/** The choice between the frames of an .md2 blended, and switched half-way from frame to frame. */

import { putCharacter } from "../../net/upload";
import { el } from "../../ui/dom";

export class FrameSwitch {
  readonly element: HTMLElement;
  private readonly box = el("input", { type: "checkbox", id: "import-switched" });

  constructor(private readonly file: File) {
    this.element = el(
      "label",
      { class: "import-switch", for: "import-switched" },
      this.box,
      " switch from frame to frame",
    );
  }

  /** Returns the choice for a file that is an .md2; null for other files. */
  static of(file: File): FrameSwitch | null {
    return /\.md2$/i.test(file.name) ? new FrameSwitch(file) : null;
  }

  /** Uploads the character again if its frames shall be switched. */
  async apply(character: string, signal: AbortSignal): Promise<void> {
    if (this.box.checked)
      await putCharacter(character, this.file, () => undefined, signal, { inbetween: "switched" });
  }
}
