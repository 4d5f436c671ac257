/** Counts actions by name over the stage view and plays their tones. */

import "./actionCounter.css";
import { signal } from "@preact/signals-core";
import { html } from "lit-html";
import { repeat } from "lit-html/directives/repeat.js";
import { flash } from "../../ui/dom";
import { draw } from "../../ui/draw";
import type { App } from "../../view/app";
import { Sounds } from "./sounds";

const MOST_NAMES = 8;
/** Raised events between actors are not counted. */
const RAISE = "raise";

export function actionCounterPanel(host: HTMLElement, { commands, playback, session, stage }: App): void {
  const sounds = new Sounds();
  const isMuted = signal(sounds.muted);
  /** The names with their counts; the latest comes first. */
  const counts = signal<ReadonlyMap<string, number>>(new Map());
  let counted = "";

  const toggle = (): void => void (isMuted.value = sounds.muted = !sounds.muted);
  draw(
    host,
    () =>
      html`<ul aria-label="actions">
          ${repeat(
            counts.value,
            ([name]) => name,
            ([name, times]) =>
              html`<li data-action=${name}><b>${times}</b><span .textContent=${name}></span></li>`,
          )}
        </ul>
        <button
          type="button"
          class="plain"
          title="sound of actions"
          aria-pressed=${!isMuted.value}
          ?hidden=${!counts.value.size}
          .textContent=${isMuted.value ? "sound: off" : "sound: on"}
          @click=${toggle}
        ></button>`,
  );
  commands.add({ keys: [], words: "sound of actions: on, off", act: toggle });
  session.actions.on(({ name }) => {
    if (name === RAISE) return;
    const latest = [name, (counts.value.get(name) ?? 0) + 1] as const;
    const others = [...counts.value].filter(([other]) => other !== name);
    counts.value = new Map([latest, ...others].slice(0, MOST_NAMES));
    flash(host.querySelector("li")!, "fired");
    if (playback.looking.value === null) sounds.play(name);
  });
  stage.hello.subscribe((hello) => {
    if (!hello || hello.stage === counted) return;
    counted = hello.stage;
    counts.value = new Map();
  });
}
