/** The feet of the watched machine's character, and when they stand in its clips. */

import { signal } from "@preact/signals-core";
import * as api from "../net/api";
import type { ClipContactsView, FeetView } from "../net/types/api.generated";
import type { WatchedMachine } from "./watchedMachine";

export class FootContacts {
  /** Null: not read yet, or the character has no feet. */
  readonly view = signal<FeetView | null>(null);
  private wanted = "";

  constructor(machine: WatchedMachine) {
    machine.info.subscribe((info) => {
      if (info) void this.read(info.name, info.version);
    });
  }

  /** The contacts of a clip; undefined: none are known. */
  of(clip: string | null): ClipContactsView | undefined {
    return this.view.value?.clips.find((one) => one.clip === clip);
  }

  private async read(name: string, version: number): Promise<void> {
    const wanted = `${name} ${version}`;
    if (wanted === this.wanted) return;
    this.wanted = wanted;
    const feet = await api.feet(name).catch(() => null);
    if (wanted === this.wanted) this.view.value = feet;
  }
}
