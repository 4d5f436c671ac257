/** Shows the state of the connection and its rates, in the header. */

import "./status.css";
import type { Session } from "../../state/session";
import { el, say } from "../../ui/dom";

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

export class StatusPanel {
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
    private readonly session: Session,
    drawn: (now: number) => number,
  ) {
    const { received, trip } = session;
    this.readings = [
      this.reading("Hz", "frames received per second", (now) => round(received.perSecond(now))),
      this.reading("ms", "round trip to the server", () =>
        trip.milliseconds === null ? "–" : round(trip.milliseconds),
      ),
      this.reading("kB/s", "received", (now) => round(received.amountPerSecond(now) / 1000)),
      this.reading("fps", "frames drawn per second", (now) => round(drawn(now))),
    ];
    this.host.prepend(this.dot);
    this.dot.addEventListener("click", () => session.retry());
    for (const signal of [session.link, session.status, session.looking]) signal.on(() => this.show());
  }

  private reading(unit: string, title: string, read: Reading["read"]): Reading {
    const value = el("b", {}, "–");
    this.host.append(el("span", { class: "reading", title, "data-unit": unit }, value, ` ${unit}`));
    return { value, read };
  }

  private show(): void {
    const { state, detail } = this.session.link.value;
    const word =
      state === "live"
        ? this.liveWord()
        : { connecting: "connecting", lost: "lost, trying again", refused: "refused" }[state];
    this.host.dataset["link"] = state === "live" ? word : state;
    const { trouble } = this.session.status.value;
    this.dot.title = { slow: this.slowness(), "not kept": trouble, "no answer": SILENCE }[word] ?? detail;
    say(this.word, word);
  }

  /** What matters most about a stage whose frames arrive. */
  private liveWord(): "no answer" | "not kept" | "past" | "paused" | "slow" | "live" {
    const { trouble, paused, pace } = this.session.status.value;
    if (this.silent) return "no answer";
    if (trouble) return "not kept";
    if (this.session.looking.value !== null) return "past";
    return paused ? "paused" : pace < 1 ? "slow" : "live";
  }

  private slowness(): string {
    const percent = Math.round(this.session.status.value.pace * 100);
    return `The server runs this stage at ${percent} % of its speed: it takes more time than it may. Fewer actors help.`;
  }

  /** Updates the rates, and notices when the server says nothing any more. */
  update(now: number): void {
    const silent = now - this.session.heardAt > SILENT_MS;
    if (silent !== this.silent) {
      this.silent = silent;
      this.show();
    }
    for (const { value, read } of this.readings) say(value, read(now));
  }
}
