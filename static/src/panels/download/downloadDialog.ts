/** The dialog that lists the watched character's file formats, each with what it cannot hold. */

import "./download.css";
import { signal } from "@preact/signals-core";
import { html, type TemplateResult } from "lit-html";
import { character as known, formats } from "../../net/api";
import { reasonOf } from "../../net/reason";
import { closeButton } from "../../ui/closeButton";
import { el } from "../../ui/dom";
import { draw } from "../../ui/draw";
import type { App } from "../../view/app";
import { lossText } from "./lossText";

type Format = Awaited<ReturnType<typeof formats>>[number];

/** The button `host` opens the dialog. */
export function downloadPanel(host: HTMLElement, { machine, commands }: App): void {
  const dialog = el("dialog", { class: "download", "aria-labelledby": "download-title" });
  const title = signal("");
  const problem = signal("");
  const rows = signal<readonly Format[]>([]);
  const clips = signal<readonly string[]>([]);
  /** The clip that comes first in the file. */
  const first = signal("");
  /** Counts the questions to the server, so that only the answer to the last one is shown. */
  let asked = 0;

  /** Opens the dialog, and asks the server for the formats. */
  async function open(): Promise<void> {
    const character = machine.info.value?.character;
    if (character === undefined) return;
    const request = ++asked;
    title.value = `Download ${character}`;
    problem.value = "";
    rows.value = clips.value = [];
    dialog.showModal();
    try {
      const [found, facts] = await Promise.all([formats(character), known(character)]);
      if (request !== asked) return;
      clips.value = facts.clips.map(({ name }) => name);
      first.value = clips.value[0] ?? "";
      rows.value = found;
    } catch (error) {
      if (request === asked) problem.value = reasonOf(error);
    }
  }

  function row({ file, format, suffix, lost }: Format): TemplateResult {
    const address = new URL(file.slice(1), document.baseURI);
    if (first.value) address.searchParams.set("clip", first.value);
    return html`<li>
      <a href=${address.href} download .textContent=${`${format} (${suffix})`}></a>
      <span class="lost" .textContent=${lossText(lost)}></span>
    </li>`;
  }

  document.body.append(dialog);
  dialog.addEventListener("keydown", (press) => press.stopPropagation());
  draw(dialog, () => {
    const choose = ({ target }: Event): void => void (first.value = (target as HTMLSelectElement).value);
    return html`${closeButton}
      <h2 id="download-title" .textContent=${title.value}></h2>
      <p class="problem" role="alert" .textContent=${problem.value}></p>
      <label class="clip" ?hidden=${clips.value.length < 2}>
        first clip
        <select @change=${choose}>
          ${clips.value.map((clip) => html`<option value=${clip} .textContent=${clip}></option>`)}
        </select>
      </label>
      <ul>
        ${rows.value.map(row)}
      </ul>`;
  });
  host.addEventListener("click", () => void open());
  commands.add({ keys: [], words: "download the character", act: () => void open() });
}
