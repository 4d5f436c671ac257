/** The stages of the server, as it told them last: read again when this page watches another one. */

import { signal } from "@preact/signals-core";
import * as api from "../net/api";
import type { StageInfo } from "../net/protocol";
import type { WatchedStage } from "./watchedStage";

export class StageList {
  readonly all = signal<readonly StageInfo[]>([]);

  constructor(stage: WatchedStage) {
    stage.hello.subscribe((hello) => hello && void this.read());
  }

  /** Asks the server again; without an answer the list stays. */
  async read(): Promise<void> {
    this.all.value = await api.stages().catch(() => this.all.value);
  }
}

/** Returns what people call a stage. */
export function nameOfStage({ id, name, scene, machines }: StageInfo): string {
  return name || (id === "main" ? id : scene || machines.join(", ") || id);
}
