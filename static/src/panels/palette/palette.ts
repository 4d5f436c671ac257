/** Finds commands and everything that has a name, by some of its letters. */

import type { App } from "../../view/app";
import { find } from "../../ui/chooser";
import { type Hit, hitsOf } from "./hits";

async function openPalette(app: App): Promise<void> {
  const { stageList } = app;
  const known = (): Hit[] => hitsOf(app, stageList.all.value);
  const title = "find a command, state, event, clip, joint, machine, stage";
  const hit = await find(title, known(), stageList.read().then(known));
  hit?.act();
}

/** The button `host` opens the palette, as its key does. */
export function palettePanel(host: HTMLElement, app: App): void {
  const open = (): void => {
    if (!document.querySelector("dialog[open]")) void openPalette(app);
  };
  app.commands.add({ keys: ["ctrl+k"], words: "find anything", act: open });
  host.addEventListener("click", open);
}
