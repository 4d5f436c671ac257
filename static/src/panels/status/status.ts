/** Shows the state of the connection and its rates, in the header. */

import "./status.css";
import { effect, signal } from "@preact/signals-core";
import { html } from "lit-html";
import type { Link } from "../../net/connection";
import type { StageStatus } from "../../state/watchedStage";
import { draw } from "../../ui/draw";
import type { App } from "../../view/app";

const READ_MS = 500;
/** Three times as long as the server is ever silent if it has time. */
const SILENT_MS = 3000;
const SILENCE = "The line is open, but the server says nothing: it has no time, or the network is gone.";

function rounded(value: number): string {
  return value >= 10 ? value.toFixed(0) : value.toFixed(1);
}

/** What the page knows of its connection. */
export interface Connected {
  link: Link;
  /** Whether the server has said nothing for too long. */
  isSilent: boolean;
  status: Pick<StageStatus, "trouble" | "paused" | "pace">;
  isLive: boolean;
}

/** Returns what matters most, in a word or two. */
export function linkWord({ link, isSilent, status, isLive }: Connected): string {
  if (link === "lost") return "lost, trying again";
  if (link === "full") return "full, trying again";
  if (link !== "live") return link;
  if (isSilent) return "no answer";
  if (status.trouble) return "not kept";
  if (!isLive) return "past";
  return status.paused ? "paused" : status.pace < 1 ? "slow" : "live";
}

function slowness(pace: number): string {
  return `The server runs this stage at ${Math.round(pace * 100)} % of its speed: it takes more time than it may. Fewer actors help.`;
}

export function statusPanel(host: HTMLElement, app: App): void {
  const { line, stage, playback, frames, session, view } = app;
  const now = signal(performance.now());
  setInterval(() => (now.value = performance.now()), READ_MS);

  const word = (): string =>
    linkWord({
      link: line.link.value.state,
      isSilent: now.value - session.heardAt > SILENT_MS,
      status: stage.status.value,
      isLive: playback.isLive,
    });
  const title = (): string => {
    const { trouble, pace } = stage.status.value;
    const reasons: Record<string, string> = {
      slow: slowness(pace),
      "not kept": trouble,
      "no answer": SILENCE,
    };
    return reasons[word()] ?? line.link.value.detail;
  };
  const rates = (): [string, string, number | null][] => [
    ["Hz", "frames received per second", frames.received.perSecond(now.value)],
    ["ms", "round trip to the server", session.trip.milliseconds],
    ["kB/s", "received", frames.received.amountPerSecond(now.value) / 1000],
    ["fps", "frames drawn per second", view.drawn.perSecond(now.value)],
  ];

  effect(() => {
    const { state } = line.link.value;
    host.dataset["link"] = state === "live" ? word() : state;
  });
  draw(
    host,
    () =>
      html`<button
          type="button"
          class="link"
          aria-live="polite"
          title=${title()}
          @click=${() => line.retry()}
        >
          <i class="dot"></i><span class="word" .textContent=${word()}></span>
        </button>
        ${rates().map(
          ([unit, words, value]) =>
            html`<span class="reading" title=${words} data-unit=${unit}
              ><b .textContent=${value === null ? "–" : rounded(value)}></b> ${unit}</span
            >`,
        )}`,
  );
}
