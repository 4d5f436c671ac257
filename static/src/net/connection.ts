/** Connects to a stage: opens the socket, checks the version, retries with growing pauses. */

import {
  type ClientMessage,
  type FrameKind,
  type ServerMessage,
  type Skinning,
  SUBPROTOCOL,
  parseMessage,
} from "./protocol";
import type { Delivery } from "./relay";
import { type FrameSocket, WorkerSocket } from "./workerSocket";

export type Link = "connecting" | "live" | "lost" | "full" | "refused";

export interface Handlers {
  /** The link changed its state; `detail` is for the user. */
  link(state: Link, detail: string): void;
  message(message: ServerMessage): void;
  /** A frame came; it is acknowledged already. */
  frame(delivery: Delivery): void;
  /** An attempt failed before the hello: the stage may be gone. */
  failed(): void;
}

export type OpenSocket = (url: string, protocol: string) => FrameSocket;

const FIRST_PAUSE_MS = 250;
const LONGEST_PAUSE_MS = 5000;

/** Milliseconds to wait before attempt `n` (0, 1, …). */
export function pauseBefore(n: number): number {
  return Math.min(LONGEST_PAUSE_MS, FIRST_PAUSE_MS * 2 ** n);
}

export class Connection {
  private line: FrameSocket | null = null;
  private attempts = 0;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private heard = false;
  private turnedAway = false;

  constructor(
    private readonly handlers: Handlers,
    private readonly open: OpenSocket = (url, protocol) => new WorkerSocket(url, protocol),
  ) {}

  private url = (): string => "";

  /**
   * Closes the old connection and connects to a stage; `frames` and `skinning` are asked for the kind of
   * frames, and the server's way of skinning, at each attempt.
   */
  connect(stage: string, frames: () => FrameKind, skinning: () => Skinning | null = () => null): void {
    this.url = () => {
      const path = `api/stages/${encodeURIComponent(stage)}/stream?frames=${frames()}`;
      const way = skinning();
      const place = new URL(way ? `${path}&skinning=${way}` : path, document.baseURI);
      place.protocol = place.protocol === "https:" ? "wss:" : "ws:";
      return place.href;
    };
    this.attempts = 0;
    this.start();
  }

  /** Sends `message` if the socket is open; returns whether it was sent. */
  send(message: ClientMessage): boolean {
    if (!this.line?.open) return false;
    this.line.send(JSON.stringify(message));
    return true;
  }

  /** Gives up until `retryNow`: the server lets this browser in no more; `detail` is for the user. */
  refuse(detail: string): void {
    this.close();
    this.turnedAway = true;
    this.handlers.link("refused", detail);
  }

  /** Says that the stage is full, while the connection tries again; `detail` is for the user. */
  awaitRoom(detail: string): void {
    if (!this.heard) this.handlers.link("full", detail);
  }

  /** Retries at once. */
  retryNow(): void {
    if (this.timer === undefined && !this.turnedAway) return;
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
    this.heard = this.turnedAway = false;
    this.handlers.link("connecting", this.attempts ? `trying again (${this.attempts})` : "connecting");
    const line = this.open(this.url(), SUBPROTOCOL);
    const mine = (): boolean => this.line === line;
    line.ontext = (text) => mine() && this.receive(text);
    line.onframe = (delivery) => mine() && this.handlers.frame(delivery);
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
      this.handlers.link(
        "refused",
        `the server speaks ${version}, this page ${SUBPROTOCOL}: reload the page`,
      );
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
