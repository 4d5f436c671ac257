/**
 * Buttons to pause, step, set the speed and go live, and the tick counter. Pause and speed act on the stage,
 * for all viewers; the replay is this page's own.
 */

import { effect } from "@preact/signals-core";
import * as api from "../../net/api";
import type { App } from "../../view/app";
import { el, say } from "../../ui/dom";
import { type IconName, icon } from "../../ui/icons";

const SPEEDS = [0.1, 0.25, 0.5, 1, 2];

function button(name: IconName, label: string, key: string, act: () => void): HTMLButtonElement {
  const made = el(
    "button",
    { type: "button", class: "plain square", "aria-label": label, title: `${label} (${key})` },
    icon(name),
  );
  made.addEventListener("click", act);
  return made;
}

function clock(ticks: number, rate: number): string {
  const seconds = ticks / rate;
  return `${String(Math.floor(seconds / 60)).padStart(2, "0")}:${(seconds % 60).toFixed(2).padStart(5, "0")}`;
}

export class Transport {
  private readonly play = button("pause", "pause", "P", () => this.toggle());
  /** Where the timeline puts its own buttons. */
  readonly tools = el("span", { id: "tools" });
  private readonly speed = el("select", { "aria-label": "speed", title: "speed of the stage" });
  private readonly counter = el("output", { class: "tick", "aria-label": "tick" });
  private readonly time = el("span", { class: "time" });
  private readonly liveButton = el(
    "button",
    { type: "button", class: "live-button", title: "back to the present (L)" },
    el("i", { class: "dot" }),
    "live",
  );

  constructor(
    host: HTMLElement,
    private readonly app: App,
  ) {
    const back = button("back", "one tick back", ",", () => this.step(-1));
    const forward = button("forward", "one tick forward", ".", () => this.step(1));
    this.liveButton.addEventListener("click", () => app.playback.live());
    this.speed.addEventListener("change", () => this.setSpeed(Number(this.speed.value)));
    host.append(
      back,
      this.play,
      forward,
      this.speed,
      this.tools,
      el("span", { class: "space" }),
      this.time,
      el("label", { class: "counter" }, "tick ", this.counter),
      this.liveButton,
    );
    app.stage.status.subscribe(({ speed }) => this.showSpeed(speed));
    effect(() => this.show());
    app.frame.on(() => this.tell());
    app.commands.add(
      { keys: ["p"], words: "pause, play", act: () => this.toggle() },
      { keys: [","], words: "one tick back", act: () => this.step(-1) },
      { keys: ["."], words: "one tick forward", act: () => this.step(1) },
      { keys: ["l"], words: "live", act: () => app.playback.live() },
      ...SPEEDS.map((speed) => ({
        keys: [],
        words: `speed of the stage: ${speed}×`,
        act: () => this.setSpeed(speed),
      })),
    );
  }

  private setSpeed(speed: number): void {
    void this.app.session.command((stage, viewer) => api.speed(stage, speed, viewer));
  }

  /** Plays or pauses the replay while the past is shown, else the stage. */
  private toggle(): void {
    if (this.app.playback.looking.value !== null) return this.app.playback.toggle();
    const paused = !this.app.stage.status.value.paused;
    void this.app.session.command((stage, viewer) => api.pause(stage, paused, viewer));
  }

  /** Steps one tick; past the head the stage pauses and makes the step. */
  private step(ticks: 1 | -1): void {
    if (this.app.playback.looking.value !== null || ticks < 0) {
      if (this.app.playback.step(ticks)) return;
      this.app.playback.live();
    }
    const paused = this.app.stage.status.value.paused;
    void this.app.session.command(async (stage, viewer) => {
      if (!paused) await api.pause(stage, true, viewer);
      await api.step(stage, 1, viewer);
    });
  }

  private showSpeed(speed: number): void {
    const speeds = SPEEDS.includes(speed) ? SPEEDS : [...SPEEDS, speed].sort((a, b) => a - b);
    this.speed.replaceChildren(
      ...speeds.map((value) => el("option", { value, selected: value === speed }, `${value}×`)),
    );
    this.speed.value = String(speed);
  }

  private show(): void {
    const past = this.app.playback.looking.value !== null;
    const running = past ? this.app.playback.replaying.value : !this.app.stage.status.value.paused;
    this.play.replaceChildren(icon(running ? "pause" : "play"));
    const label = running ? "pause" : past ? "replay from here" : "play";
    this.play.setAttribute("aria-label", label);
    this.play.title = `${label} (P)`;
    this.liveButton.setAttribute("aria-pressed", String(!past));
  }

  /** Says the shown tick. */
  private tell(): void {
    const { tick, rate } = this.app.stage;
    say(this.counter, String(tick));
    say(this.time, clock(tick, rate));
  }
}
