/** The socket to the watched stage: its link, and what comes through it. */

import { signal } from "@preact/signals-core";
import { Connection, type Link } from "../net/connection";
import type { ClientMessage, FrameKind, ServerMessage, Skinning } from "../net/protocol";
import type { Delivery } from "../net/relay";
import { Event } from "./event";

export class Line {
  readonly link = signal<{ state: Link; detail: string }>({ state: "connecting", detail: "" });
  readonly messages = new Event<ServerMessage>();
  readonly frames = new Event<Delivery>();
  /** Emitted if an attempt fails before the hello: the stage may be gone. */
  readonly failed = new Event<null>();
  private readonly connection = new Connection({
    link: (state, detail) => (this.link.value = { state, detail }),
    message: (message) => this.messages.emit(message),
    frame: (delivery) => this.frames.emit(delivery),
    failed: () => this.failed.emit(null),
  });

  connect(stage: string, frames: () => FrameKind, skinning: () => Skinning | null): void {
    this.connection.connect(stage, frames, skinning);
  }

  /** Returns whether the message was sent. */
  readonly send = (message: ClientMessage): boolean => this.connection.send(message);

  close(): void {
    this.connection.close();
  }

  retry(): void {
    this.connection.retryNow();
  }

  /** Says that the stage is full, while the line tries again; `detail` is for the user. */
  awaitRoom(detail: string): void {
    this.connection.awaitRoom(detail);
  }

  /** Gives up until `retry`; `detail` is for the user. */
  refuse(detail: string): void {
    this.connection.refuse(detail);
  }
}
