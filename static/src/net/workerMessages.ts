/** Messages between the page and the worker that owns the socket. */

import type { Delivery } from "./relay";

export type ToWorker =
  | { kind: "open"; url: string; protocol: string }
  | { kind: "send"; text: string }
  | { kind: "taken" }
  | { kind: "close" };
export type FromWorker =
  | { kind: "open" }
  | { kind: "text"; text: string }
  | ({ kind: "frame" } & Delivery)
  | { kind: "close"; code: number; reason: string };
