/** Shows the state of the connection and its rates, in the header. */

import "./status.css";
import type { Session } from "../../state/session";
import { el, say } from "../../ui/dom";

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
    const past = this.session.looking.value !== null;
    const word =
      state !== "live"
        ? { connecting: "connecting", lost: "lost, trying again", refused: "refused" }[state]
        : past
          ? "past"
          : this.session.status.value.paused
            ? "paused"
            : "live";
    this.host.dataset["link"] = state === "live" ? word : state;
    this.dot.title = detail;
    say(this.word, word);
  }

  /** Updates the rates. */
  update(now: number): void {
    for (const { value, read } of this.readings) say(value, read(now));
  }
}
