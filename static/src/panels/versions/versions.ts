/** Lists the versions of the machine, newest first; an open one shows its differences by cell, and can be restored. */

import "./versions.css";
import { effect, signal } from "@preact/signals-core";
import { html, nothing, type TemplateResult } from "lit-html";
import { differences } from "../../net/edits";
import type { MachineVersion, VersionDifferences } from "../../net/protocol";
import { reasonOf } from "../../net/reason";
import { draw } from "../../ui/draw";
import type { App } from "../../view/app";
import { type DifferenceLine, differenceLines } from "./differenceLines";

interface Opened {
  version: number;
  /** With which version it is compared. */
  since: number;
  said: VersionDifferences | string | null;
}

/** Rows that are shown until the user asks for more: after an hour of edits there are hundreds. */
const NEWEST = 50;

const when = (seconds: number): string =>
  new Date(seconds * 1000).toLocaleTimeString([], { hour: "2-digit", minute: "2-digit", second: "2-digit" });

export function versionsPanel(host: HTMLElement, app: App): void {
  const { editing, machine, inspection } = app;
  const opened = signal<Opened | null>(null);
  const isWhole = signal(false);
  let shown: string | undefined;

  async function compare(version: number, since: number): Promise<void> {
    const now = (opened.value = { version, since, said: null });
    const name = machine.info.value?.name ?? "";
    const said = await differences(name, version, since).catch(reasonOf);
    if (opened.value === now) opened.value = { ...now, said };
  }

  function toggle(index: number): void {
    const { version } = editing.versions.value[index]!;
    const before = editing.versions.value[index - 1];
    if (opened.value?.version === version) opened.value = null;
    else if (before) void compare(version, before.version);
    else opened.value = { version, since: version, said: "the oldest version that is kept" };
  }

  function go({ layer, state, event }: NonNullable<DifferenceLine["cell"]>): void {
    const layers = machine.info.value?.layers ?? [];
    const at = Math.max(
      0,
      layers.findIndex(({ name }) => name === layer),
    );
    inspection.cells.emit({ layer: at, state, event, text: null });
  }

  const line = ({ words, before, after, cell }: DifferenceLine): TemplateResult =>
    html`<li>
      ${
        cell
          ? html`<button type="button" class="where" .textContent=${words} @click=${() => go(cell)}></button>`
          : html`<b .textContent=${words}></b>`
      }
      ${before === null ? nothing : html`<del .textContent=${before || "blank"}></del>`}
      ${after === null ? nothing : html`<ins .textContent=${after || "blank"}></ins>`}
    </li>`;

  function details({ version, since, said }: Opened, newest: number): TemplateResult {
    if (said === null) return html`<p>comparing …</p>`;
    if (typeof said === "string") return html`<p .textContent=${said}></p>`;
    const lines = differenceLines(said);
    const other = since === newest || version === newest ? null : newest;
    return html`<p>
        <span .textContent=${`since version ${Math.min(version, since)}`}></span>
        ${
          other === null
            ? nothing
            : html`<button type="button" @click=${() => void compare(newest, version)}>
                compare with now
              </button>`
        }
      </p>
      <ul>
        ${lines.length ? lines.map(line) : html`<li>the same table</li>`}
      </ul>`;
  }

  function row(version: MachineVersion, index: number, newest: number): TemplateResult {
    const open = opened.value && (opened.value.version === version.version ? opened.value : null);
    const by = version.author ? ` by ${version.author}` : "";
    return html`<li aria-current=${version.version === newest}>
      <button type="button" class="version-row" aria-expanded=${open !== null} @click=${() => toggle(index)}>
        <b .textContent=${`v${version.version}`}></b>
        <span .textContent=${version.what}></span>
        <time .textContent=${when(version.at) + by}></time>
      </button>
      ${
        version.version === newest
          ? nothing
          : html`<button
              type="button"
              class="restore"
              aria-label=${`restore version ${version.version}`}
              title="make its text the newest version; an undo takes it back"
              @click=${() => void editing.restore(version.version)}
            >
              restore
            </button>`
      }
      ${open ? html`<div class="differences">${details(open, newest)}</div>` : nothing}
    </li>`;
  }

  draw(host, () => {
    const versions = editing.versions.value;
    const newest = versions.at(-1)?.version ?? 0;
    const older = isWhole.value ? 0 : Math.max(0, versions.length - NEWEST);
    return html`<ol aria-label="versions, newest first">
        ${versions
          .slice(older)
          .map((version, i) => row(version, older + i, newest))
          .reverse()}
      </ol>
      ${
        older > 0
          ? html`<button type="button" class="older" @click=${() => (isWhole.value = true)}>
              ${older} older
            </button>`
          : nothing
      }`;
  });
  effect(() => {
    if (machine.info.value?.name === shown) return;
    opened.value = null;
    isWhole.value = false;
    shown = machine.info.value?.name;
  });
}
