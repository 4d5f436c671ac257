/** The line to a stage: opens, checks the version, and comes back by itself with growing pauses. */

import { type ClientMessage, type FrameKind, type ServerMessage, SUBPROTOCOL, parseMessage } from "./protocol";
import type { Handed } from "./relay";
import { type Line, WorkerSocket } from "./workersocket";

export type Link = "connecting" | "live" | "lost" | "refused";

export interface Handlers {
  /** The state of the line; `detail` is for a person. */
  link(state: Link, detail: string): void;
  message(message: ServerMessage): void;
  /** A binary message, acknowledged already. */
  frame(handed: Handed): void;
  /** An attempt failed before anything was said: is the stage still there? */
  failed(): void;
}

export type LineFactory = (url: string, protocol: string) => Line;

const FIRST_PAUSE_MS = 250;
const LONGEST_PAUSE_MS = 5000;

/** How long to wait before attempt `n` (0, 1, …), in milliseconds. */
export function pauseBefore(n: number): number {
  return Math.min(LONGEST_PAUSE_MS, FIRST_PAUSE_MS * 2 ** n);
}

export class Connection {
  private line: Line | null = null;
  private attempts = 0;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private heard = false;

  constructor(
    private readonly handlers: Handlers,
    private readonly open: LineFactory = (url, protocol) => new WorkerSocket(url, protocol),
  ) {}

  private url = (): string => "";

  /** Leaves what was connected and connects to a stage's stream, in the kind of frames that is chosen at each attempt. */
  connect(stage: string, frames: () => FrameKind): void {
    this.url = () => {
      const place = new URL(`api/stages/${encodeURIComponent(stage)}/stream?frames=${frames()}`, document.baseURI);
      place.protocol = place.protocol === "https:" ? "wss:" : "ws:";
      return place.href;
    };
    this.attempts = 0;
    this.start();
  }

  /** Sends `message` if the line is open; says whether it was. */
  send(message: ClientMessage): boolean {
    if (!this.line?.open) return false;
    this.line.send(JSON.stringify(message));
    return true;
  }

  /** Tries again at once: the network came back, or the user asked. */
  retryNow(): void {
    if (this.timer === undefined) return;
    this.attempts = 0;
    this.start();
  }

  close(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    const old = this.line;
    this.line = null;
    old?.close();
  }

  private start(): void {
    this.close();
    this.heard = false;
    this.handlers.link("connecting", this.attempts ? `trying again (${this.attempts})` : "connecting");
    const line = this.open(this.url(), SUBPROTOCOL);
    const mine = (): boolean => this.line === line;
    line.ontext = (text) => mine() && this.receive(text);
    line.onframe = (handed) => mine() && this.handlers.frame(handed);
    line.onclose = (code, reason) => mine() && this.closed(code, reason);
    this.line = line;
  }

  private receive(text: string): void {
    const message = parseMessage(text);
    if (message?.type === "hello" && !this.accepts(message.version)) return;
    if (message) this.handlers.message(message);
  }

  private accepts(version: string): boolean {
    if (version !== SUBPROTOCOL) {
      this.close();
      this.handlers.link("refused", `the server speaks ${version}, this page ${SUBPROTOCOL}: reload the page`);
      return false;
    }
    this.heard = true;
    this.attempts = 0;
    this.handlers.link("live", "live");
    return true;
  }

  private closed(code: number, reason: string): void {
    this.line = null;
    const pause = pauseBefore(this.attempts++);
    const why = reason || (code === 4008 ? "this page was too slow" : "connection lost");
    this.handlers.link("lost", why);
    this.timer = setTimeout(() => this.start(), pause);
    if (!this.heard) this.handlers.failed();
  }
}
