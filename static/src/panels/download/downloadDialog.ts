/** The dialog that lists the watched character's file formats, each with what it cannot hold. */

import "./download.css";
import type { App } from "../../view/app";
import { formats, character as known } from "../../net/api";
import { reasonOf } from "../../net/reason";
import { el, say } from "../../ui/dom";
import { lossText } from "./lossText";

class DownloadDialog {
  private readonly title = el("h2", { id: "download-title" });
  private readonly clip = el("select", {});
  private readonly choice = el("label", { class: "clip" }, "first clip ", this.clip);
  private readonly list = el("ul", {});
  private readonly problem = el("p", { class: "problem", role: "alert" });
  private readonly dialog: HTMLDialogElement;

  /** `watched` returns the watched character. */
  constructor(private readonly watched: () => string | null) {
    const close = el("button", { type: "button", class: "plain close", "aria-label": "esc: close" }, "esc");
    this.dialog = el(
      "dialog",
      { class: "download", "aria-labelledby": "download-title" },
      close,
      this.title,
      this.problem,
      this.choice,
      this.list,
    );
    document.body.append(this.dialog);
    close.addEventListener("click", () => this.dialog.close());
    this.dialog.addEventListener("keydown", (press) => press.stopPropagation());
  }

  /** Opens the dialog, and asks the server for the formats. */
  async open(): Promise<void> {
    const character = this.watched();
    if (character === null) return;
    say(this.title, `Download ${character}`);
    say(this.problem, "");
    this.list.replaceChildren();
    this.choice.hidden = true;
    this.dialog.showModal();
    try {
      const [rows, { clips }] = await Promise.all([formats(character), known(character)]);
      this.clip.replaceChildren(...clips.map(({ name }) => el("option", { value: name }, name)));
      this.choice.hidden = clips.length < 2;
      this.list.replaceChildren(...rows.map((row) => this.row(row)));
    } catch (error) {
      say(this.problem, reasonOf(error));
    }
  }

  private row(row: Awaited<ReturnType<typeof formats>>[number]): HTMLElement {
    const file = new URL(row.file.slice(1), document.baseURI);
    const link = el("a", { href: file.href, download: true }, `${row.format} (${row.suffix})`);
    link.addEventListener("click", () => {
      if (this.clip.value) file.searchParams.set("clip", this.clip.value);
      link.href = file.href;
    });
    return el("li", {}, link, el("span", { class: "lost" }, lossText(row.lost)));
  }
}

/** The button `host` opens the dialog. */
export function downloadPanel(host: HTMLElement, { machine, commands }: App): void {
  const dialog = new DownloadDialog(() => machine.info.value?.character ?? null);
  host.addEventListener("click", () => void dialog.open());
  commands.add({ keys: [], words: "download the character", act: () => void dialog.open() });
}
