/** Takes your own character or motion to the page, and watches what is made of it. */

import { effect } from "@preact/signals-core";
import type { App } from "../../view/app";
import { dropZone } from "./dropZone";
import { ImportDialog } from "./importDialog";

/** Calls `then` once the page knows the machine that it has begun to watch. */
function whenWatched({ machine }: App, name: string, then: () => void): void {
  const forget = effect(() => {
    if (machine.info.value?.name !== name || !machine.isActors) return;
    queueMicrotask(() => forget());
    then();
  });
}

/** Imports your own character: dropped on the page, or chosen with the button `host`. */
export function importPanel(host: HTMLElement, app: App): void {
  const made = async (machine: string, state = ""): Promise<void> => {
    await app.library.read();
    await app.library.openMachine(machine);
    if (state) whenWatched(app, machine, () => void app.travel.go(state));
  };
  const dialog = new ImportDialog(
    made,
    (text, act) => app.notices.emit({ text, words: "change…", act }),
    () => app.machine.info.value?.character ?? null,
    app.view.scene.quality,
  );
  dropZone((files) => void dialog.take(files));
  host.addEventListener("click", () => dialog.choose());
  app.commands.add({
    keys: [],
    words: "add your own: a model, a machine, a motion",
    act: () => dialog.choose(),
  });
}
