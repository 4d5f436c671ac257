/** The page's end of the socket that lives in a worker. */

import type { Delivery } from "./relay";
import type { FromWorker, ToWorker } from "./workerMessages";

/** The part of a socket that the connection uses; the socket acknowledges frames itself. */
export interface FrameSocket {
  ontext: ((text: string) => void) | null;
  onframe: ((delivery: Delivery) => void) | null;
  onclose: ((code: number, reason: string) => void) | null;
  readonly open: boolean;
  send(text: string): void;
  close(): void;
}

export class WorkerSocket implements FrameSocket {
  ontext: FrameSocket["ontext"] = null;
  onframe: FrameSocket["onframe"] = null;
  onclose: FrameSocket["onclose"] = null;
  open = false;
  private readonly worker = new Worker(new URL("./socketWorker.ts", import.meta.url), { type: "module" });

  constructor(url: string, protocol: string) {
    this.worker.onmessage = ({ data }: MessageEvent<FromWorker>) => this.hear(data);
    this.post({ kind: "open", url, protocol });
  }

  send(text: string): void {
    this.post({ kind: "send", text });
  }

  /** Stops listening. Messages sent before still go out; the worker ends when its socket has closed. */
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

  private take(delivery: Delivery): void {
    this.post({ kind: "taken" });
    this.onframe?.(delivery);
  }
}
