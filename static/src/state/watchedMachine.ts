/** The machine of the watched actor, in the version that the stage plays or in a newer one. */

import { batch, signal } from "@preact/signals-core";
import * as api from "../net/api";
import { versions } from "../net/edits";
import type { LayerInfo, MachineInfo } from "../net/protocol";
import { reasonOf } from "../net/reason";
import type { Event } from "./event";
import type { Notice } from "./notice";
import type { Selection } from "./selection";

export class WatchedMachine {
  readonly info = signal<MachineInfo | null>(null);
  /** Resolves when the server has answered the edits of this page. */
  answered: () => Promise<unknown> = () => Promise.resolve();
  private playedVersion: number | undefined;
  /** Whether the shown machine may be another one than the server has now. */
  private doubtful = false;

  constructor(
    private readonly selection: Selection,
    private readonly notices: Event<Notice>,
  ) {}

  /** The shown layer. */
  get layerInfo(): LayerInfo | null {
    const layers = this.info.value?.layers ?? [];
    return layers[this.selection.layer.value] ?? layers[0] ?? null;
  }

  /** Whether `info` is the watched actor's machine: the actor may be newer than the answer. */
  get isActors(): boolean {
    return this.info.value !== null && this.info.value.name === this.selection.cast?.machine;
  }

  /** Watches an actor, and fetches its machine. */
  async choose(actor: number): Promise<void> {
    this.selection.actor.value = actor;
    await this.load();
  }

  /** Fetches the watched actor's machine, unless it is already here in the version that the stage plays. */
  async load(): Promise<void> {
    const { machine: name, version } = this.selection.cast ?? {};
    if (name === undefined || (name === this.info.value?.name && version === this.playedVersion)) return;
    if (await this.isNewest(name)) {
      this.playedVersion = version;
      return;
    }
    await api.machine(name).then(
      (machine) => {
        if (name === this.selection.cast?.machine) this.take(machine, version);
      },
      (error: unknown) => this.notices.emit(reasonOf(error)),
    );
  }

  /**
   * Whether the shown machine is `name` in its newest version, as after an edit of this page: a large one takes long to
   * read.
   */
  private async isNewest(name: string): Promise<boolean> {
    if (this.doubtful || this.info.value?.name !== name) return false;
    await this.answered();
    const newest = (await versions(name).catch(() => [])).at(-1);
    return this.info.value.name === name && this.info.value.version === newest?.version;
  }

  /**
   * Shows `machine`, unless a newer version is already shown; `played`: the version in the stage's own count.
   */
  take(machine: MachineInfo, played = this.playedVersion): void {
    this.playedVersion = played;
    const known = this.info.value;
    const older = known?.name === machine.name && known.version >= machine.version;
    if (older && !this.doubtful) return;
    this.doubtful = false;
    batch(() => {
      if (known?.name !== machine.name || this.selection.layer.value >= machine.layers.length)
        this.selection.layer.value = 0;
      this.info.value = machine;
    });
  }

  /**
   * Takes the next answer in any case: the server may have read another table when it started again. Until then the
   * known machine stays, with what is being typed in it.
   */
  doubt(): void {
    this.doubtful = true;
    this.playedVersion = undefined;
  }
}
