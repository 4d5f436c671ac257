/** The button in the header with the name of the watched stage opens the list of stages. */

import { html } from "lit-html";
import { nameOf } from "../../state/stageList";
import { draw } from "../../ui/draw";
import type { App } from "../../view/app";

export function stageNamePanel(host: HTMLElement, app: App): void {
  const { inspection, commands, session, stage, stageList } = app;
  const toggle = (): void =>
    void (inspection.drawer.value = inspection.drawer.value === "stages" ? null : "stages");
  commands.add(
    { keys: ["o"], words: "stages and forks", act: toggle },
    { keys: ["h"], words: "back to the stage main", act: () => stage.id === "main" || session.watch("main") },
  );
  draw(host, () => {
    const id = stage.hello.value?.stage ?? "";
    const known = stageList.all.value.find((one) => one.id === id);
    return html`<button
      type="button"
      class="plain"
      title="stages and forks (O); back to main (H)"
      aria-expanded=${inspection.drawer.value === "stages"}
      @click=${toggle}
    >
      <span class="stage-word">stage</span> <b .textContent=${known ? nameOf(known) : id}></b>
    </button>`;
  });
}
