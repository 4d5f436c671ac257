/** Finds commands and everything that has a name, by some of its letters. */

import * as api from "../../net/api";
import type { App } from "../../view/app";
import { find } from "../../ui/chooser";
import { hitsOf } from "./hits";

async function openPalette(app: App): Promise<void> {
  const stages = await api.stages().catch(() => []);
  const hit = await find("find a command, state, event, clip, joint, machine, stage", hitsOf(app, stages));
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
