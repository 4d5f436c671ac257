/** Names the protocol, exports its types (one folder: types/), parses its messages. */

import type { ServerMessage } from "./types/messages";

export type * from "./types/explanation";
export type * from "./types/machine";
export type * from "./types/messages";
export type * from "./types/rest";

export const SUBPROTOCOL = "statwalk.v1";

/** Parses a message; returns null if `text` is no message of the protocol. */
export function parseMessage(text: string): ServerMessage | null {
  try {
    const value: unknown = JSON.parse(text);
    const known =
      typeof value === "object" && value !== null && typeof (value as { type?: unknown }).type === "string";
    return known ? (value as ServerMessage) : null;
  } catch {
    return null;
  }
}
