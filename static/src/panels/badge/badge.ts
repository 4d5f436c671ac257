/** Shows the live state's name and phase over the stage view. */

import "./badge.css";
import { effect } from "@preact/signals-core";
import type { App } from "../../view/app";
import { el, say } from "../../ui/dom";

export function badgePanel(host: HTMLElement, { frame, frames, playback, selection }: App): void {
  const name = el("strong");
  const bar = el("i");
  const phase = el("span", { class: "phase", "aria-hidden": true }, bar);
  const note = el("span", { class: "note" });
  host.append(name, phase, note);
  effect(() => say(name, selection.stateName(selection.state.value)));
  effect(() => say(note, playback.isLive ? "" : "looking back"));
  frame.on(() => {
    const share = frames.phase();
    phase.hidden = share === null;
    bar.style.transform = `scaleX(${(share ?? 0).toFixed(3)})`;
  });
}
