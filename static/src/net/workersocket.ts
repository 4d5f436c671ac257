/** The page's end of the socket that lives in a worker. */

import type { Handed } from "./relay";

export type ToWorker = { kind: "open"; url: string; protocol: string } | { kind: "send"; text: string } | { kind: "taken" } | { kind: "close" };
export type FromWorker = { kind: "open" } | { kind: "text"; text: string } | ({ kind: "frame" } & Handed) | { kind: "close"; code: number; reason: string };

/** What the connection needs of a socket; frames are acknowledged below it. */
export interface Line {
  ontext: ((text: string) => void) | null;
  onframe: ((handed: Handed) => void) | null;
  onclose: ((code: number, reason: string) => void) | null;
  readonly open: boolean;
  send(text: string): void;
  close(): void;
}

export class WorkerSocket implements Line {
  ontext: Line["ontext"] = null;
  onframe: Line["onframe"] = null;
  onclose: Line["onclose"] = null;
  open = false;
  private readonly worker = new Worker(new URL("./socketworker.ts", import.meta.url), { type: "module" });

  constructor(url: string, protocol: string) {
    this.worker.onmessage = ({ data }: MessageEvent<FromWorker>) => this.hear(data);
    this.post({ kind: "open", url, protocol });
  }

  send(text: string): void {
    this.post({ kind: "send", text });
  }

  /** Nothing is heard any more; what was sent before still goes out, and the worker ends with its socket. */
  close(): void {
    this.open = false;
    this.worker.onmessage = null;
    this.post({ kind: "close" });
  }

  private post(message: ToWorker): void {
    this.worker.postMessage(message);
  }

  private hear(message: FromWorker): void {
    if (message.kind === "open") this.open = true;
    else if (message.kind === "text") this.ontext?.(message.text);
    else if (message.kind === "frame") this.take(message);
    else {
      this.close();
      this.onclose?.(message.code, message.reason);
    }
  }

  private take(handed: Handed): void {
    this.post({ kind: "taken" });
    this.onframe?.(handed);
  }
}
