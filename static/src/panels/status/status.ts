/** Shows the state of the connection and its rates, in the header. */

import "./status.css";
import { effect } from "@preact/signals-core";
import type { App } from "../../view/app";
import { el, say } from "../../ui/dom";

const READ_MS = 500;
/** Three times as long as the server is ever silent if it has time. */
const SILENT_MS = 3000;
const SILENCE = "The line is open, but the server says nothing: it has no time, or the network is gone.";

interface Reading {
  value: HTMLElement;
  read: (now: number) => string;
}

function round(value: number): string {
  return value >= 100 ? value.toFixed(0) : value >= 10 ? value.toFixed(0) : value.toFixed(1);
}

class StatusPanel {
  private readonly word = el("span", { class: "word" });
  private readonly dot = el(
    "button",
    { type: "button", class: "link", "aria-live": "polite" },
    el("i", { class: "dot" }),
    this.word,
  );
  private readonly readings: Reading[];
  private silent = false;

  constructor(
    private readonly host: HTMLElement,
    private readonly app: App,
  ) {
    const { received } = app.frames;
    const { trip } = app.session;
    this.readings = [
      this.reading("Hz", "frames received per second", (now) => round(received.perSecond(now))),
      this.reading("ms", "round trip to the server", () =>
        trip.milliseconds === null ? "–" : round(trip.milliseconds),
      ),
      this.reading("kB/s", "received", (now) => round(received.amountPerSecond(now) / 1000)),
      this.reading("fps", "frames drawn per second", (now) => round(app.view.drawn.perSecond(now))),
    ];
    this.host.prepend(this.dot);
    this.dot.addEventListener("click", () => app.line.retry());
    effect(() => this.show());
    setInterval(() => this.update(performance.now()), READ_MS);
  }

  private reading(unit: string, title: string, read: Reading["read"]): Reading {
    const value = el("b", {}, "–");
    this.host.append(el("span", { class: "reading", title, "data-unit": unit }, value, ` ${unit}`));
    return { value, read };
  }

  private show(): void {
    const { state, detail } = this.app.line.link.value;
    const word =
      state === "live"
        ? this.liveWord()
        : { connecting: "connecting", lost: "lost, trying again", refused: "refused" }[state];
    this.host.dataset["link"] = state === "live" ? word : state;
    const { trouble } = this.app.stage.status.value;
    this.dot.title = { slow: this.slowness(), "not kept": trouble, "no answer": SILENCE }[word] ?? detail;
    say(this.word, word);
  }

  /** What matters most about a stage whose frames arrive. */
  private liveWord(): "no answer" | "not kept" | "past" | "paused" | "slow" | "live" {
    const { trouble, paused, pace } = this.app.stage.status.value;
    if (this.silent) return "no answer";
    if (trouble) return "not kept";
    if (this.app.playback.looking.value !== null) return "past";
    return paused ? "paused" : pace < 1 ? "slow" : "live";
  }

  private slowness(): string {
    const percent = Math.round(this.app.stage.status.value.pace * 100);
    return `The server runs this stage at ${percent} % of its speed: it takes more time than it may. Fewer actors help.`;
  }

  /** Updates the rates, and notices when the server says nothing any more. */
  private update(now: number): void {
    const silent = now - this.app.session.heardAt > SILENT_MS;
    if (silent !== this.silent) {
      this.silent = silent;
      this.show();
    }
    for (const { value, read } of this.readings) say(value, read(now));
  }
}

export function statusPanel(host: HTMLElement, app: App): void {
  new StatusPanel(host, app);
}
