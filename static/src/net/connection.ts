/** The socket: opens, checks the version, acknowledges, and comes back by itself with growing pauses. */

import { type ClientMessage, type FrameKind, type ServerMessage, SUBPROTOCOL, parseMessage } from "./protocol";

export type Link = "connecting" | "live" | "lost" | "refused";

export interface Handlers {
  /** The state of the line; `detail` is for a person. */
  link(state: Link, detail: string): void;
  message(message: ServerMessage): void;
  /** A binary message; returns the tick it is of, which is then acknowledged. */
  frame(buffer: ArrayBuffer): number | null;
  /** An attempt failed before anything was said: is the stage still there? */
  failed(): void;
}

export type SocketFactory = (url: string, protocol: string) => WebSocket;

const FIRST_PAUSE_MS = 250;
const LONGEST_PAUSE_MS = 5000;

/** How long to wait before attempt `n` (0, 1, …), in milliseconds. */
export function pauseBefore(n: number): number {
  return Math.min(LONGEST_PAUSE_MS, FIRST_PAUSE_MS * 2 ** n);
}

export class Connection {
  private socket: WebSocket | null = null;
  private attempts = 0;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private heard = false;

  constructor(
    private readonly handlers: Handlers,
    private readonly open: SocketFactory = (url, protocol) => new WebSocket(url, protocol),
  ) {}

  private url = "";

  /** Leaves what was connected and connects to a stage's stream. */
  connect(stage: string, frames: FrameKind): void {
    const place = new URL(`api/stages/${encodeURIComponent(stage)}/stream?frames=${frames}`, document.baseURI);
    place.protocol = place.protocol === "https:" ? "wss:" : "ws:";
    this.url = place.href;
    this.attempts = 0;
    this.start();
  }

  /** Sends `message` if the line is open; says whether it was. */
  send(message: ClientMessage): boolean {
    if (this.socket?.readyState !== WebSocket.OPEN) return false;
    this.socket.send(JSON.stringify(message));
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
    const old = this.socket;
    this.socket = null;
    old?.close(1000);
  }

  private start(): void {
    this.close();
    this.heard = false;
    this.handlers.link("connecting", this.attempts ? `trying again (${this.attempts})` : "connecting");
    const socket = this.open(this.url, SUBPROTOCOL);
    socket.binaryType = "arraybuffer";
    socket.onmessage = (event: MessageEvent<string | ArrayBuffer>) => this.socket === socket && this.receive(event.data);
    socket.onclose = (event) => this.socket === socket && this.closed(event);
    this.socket = socket;
  }

  private receive(data: string | ArrayBuffer): void {
    if (typeof data !== "string") {
      const tick = this.handlers.frame(data);
      if (tick !== null) this.send({ type: "ack", tick });
      return;
    }
    const message = parseMessage(data);
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

  private closed(event: CloseEvent): void {
    this.socket = null;
    const pause = pauseBefore(this.attempts++);
    const why = event.reason || (event.code === 4008 ? "this page was too slow" : "connection lost");
    this.handlers.link("lost", why);
    this.timer = setTimeout(() => this.start(), pause);
    if (!this.heard) this.handlers.failed();
  }
}
