/** Buttons in the header: the watched stage opens the list of stages, its other viewers that of people. */

import "./stageName.css";
import { html, nothing, svg, type TemplateResult } from "lit-html";
import { addressWith } from "../../state/address";
import { shownAddress } from "../../state/keepAddress";
import { nameOfStage } from "../../state/stageList";
import { draw } from "../../ui/draw";
import type { App } from "../../view/app";

const FORK = svg`<path
  d="M5 4.5v7M5 8c0-2.2 6-1 6-3.5"
  fill="none" stroke="currentColor" stroke-width="1.6" stroke-linecap="round"
/><circle cx="5" cy="3.5" r="1.6" /><circle cx="11" cy="3.5" r="1.6" /><circle cx="5" cy="12.5" r="1.6" />`;

const PERSON = svg`<circle cx="8" cy="4.6" r="2.9" /><path d="M2.5 14c0-6.6 11-6.6 11 0z" />`;

export function stageNamePanel(host: HTMLElement, app: App): void {
  const { inspection, commands, notices, people, session, stage, stageList } = app;
  const toggle = (): void =>
    void (inspection.drawer.value = inspection.drawer.value === "stages" ? null : "stages");
  commands.add(
    { keys: ["o"], words: "stages and forks", act: toggle },
    { keys: ["y"], words: "copy a link to this moment", act: () => void copyLink() },
    { keys: ["h"], words: "back to the stage main", act: () => stage.id === "main" || session.watch("main") },
  );
  /**
   * Copies the address with the tick that *why* explains, or else with the shown tick; where the browser has no clipboard
   * for the page, shows the address.
   */
  async function copyLink(): Promise<void> {
    const tick = inspection.why.value ?? stage.tick;
    const link = addressWith({ ...shownAddress(app), tick }).href;
    try {
      await navigator.clipboard.writeText(link);
      notices.emit(`Copied: a link to tick ${tick}, as you see it.`);
    } catch {
      notices.emit(link);
    }
  }

  const viewers = (): TemplateResult | typeof nothing => {
    const count = people.all.value.length;
    if (count < 2) return nothing;
    return html`<button
      type="button"
      class="plain viewers"
      title="who watches this stage"
      aria-label=${`${count} viewers`}
      @click=${() => (inspection.drawer.value = "people")}
    >
      <svg viewBox="0 0 16 16" width="14" height="14" fill="currentColor" aria-hidden="true">${PERSON}</svg>
      <b .textContent=${String(count)}></b>
    </button>`;
  };
  draw(host, () => {
    const id = stage.hello.value?.stage ?? "";
    const known = stageList.all.value.find((listed) => listed.id === id);
    const name = known ? nameOfStage(known) : id;
    return html`<button
        type="button"
        class="plain"
        title=${`stage ${name}: stages and forks (O); back to main (H)`}
        aria-label=${`stage ${name}`}
        aria-expanded=${inspection.drawer.value === "stages"}
        @click=${toggle}
      >
        <svg viewBox="0 0 16 16" width="14" height="14" fill="currentColor" aria-hidden="true">${FORK}</svg>
        <span .textContent=${name}></span></button
      >${viewers()}`;
  });
}
