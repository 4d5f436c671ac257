/** Counts actions by name over the stage view and plays their tones. */

import "./actionCounter.css";
import type { Action } from "../../net/protocol";
import type { App } from "../../view/app";
import { el, flash, say } from "../../ui/dom";
import { Sounds } from "./sounds";

const MOST_NAMES = 8;
/** Raised events between actors are not counted. */
const RAISE = "raise";

interface Row {
  item: HTMLElement;
  count: HTMLElement;
  times: number;
}

class ActionCounter {
  private rows = new Map<string, Row>();
  private readonly list = el("ul", { "aria-label": "actions" });
  private readonly mute = el("button", { type: "button", class: "plain", title: "sound of actions" });
  private stage = "";

  constructor(
    host: HTMLElement,
    private readonly app: App,
    private readonly sounds = new Sounds(),
  ) {
    host.append(this.list, this.mute);
    this.mute.addEventListener("click", () => this.toggle());
    this.mute.hidden = true;
    app.commands.add({ keys: [], words: "sound of actions: on, off", act: () => this.toggle() });
    this.label();
    app.session.actions.on((action) => this.count(action));
    app.stage.hello.subscribe((hello) => {
      if (hello) this.at(hello.stage);
    });
  }

  private toggle(): void {
    this.sounds.muted = !this.sounds.muted;
    this.label();
  }

  private label(): void {
    say(this.mute, this.sounds.muted ? "sound: off" : "sound: on");
    this.mute.setAttribute("aria-pressed", String(!this.sounds.muted));
  }

  /** Starts from zero on another stage. */
  private at(stage: string): void {
    if (stage === this.stage) return;
    this.stage = stage;
    this.rows.clear();
    this.list.replaceChildren();
    this.mute.hidden = true;
  }

  private count({ name }: Action): void {
    if (name === RAISE) return;
    const row = this.rows.get(name) ?? this.add(name);
    row.times += 1;
    say(row.count, String(row.times));
    this.list.prepend(row.item);
    flash(row.item, "fired");
    if (this.app.playback.looking.value === null) this.sounds.play(name);
  }

  private add(name: string): Row {
    const count = el("b", {}, "0");
    const row = { item: el("li", { "data-action": name }, count, el("span", {}, name)), count, times: 0 };
    this.rows.set(name, row);
    this.mute.hidden = false;
    while (this.rows.size > MOST_NAMES) {
      const [oldest] = this.list.lastElementChild
        ? [(this.list.lastElementChild as HTMLElement).dataset["action"]!]
        : [name];
      this.rows.delete(oldest);
      this.list.lastElementChild?.remove();
    }
    return row;
  }
}

export function actionCounterPanel(host: HTMLElement, app: App): void {
  new ActionCounter(host, app);
}
