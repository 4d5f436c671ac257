/** Reads what the frames do not carry: the machine in the version that the stage plays, its history, its log. */

import * as api from "../net/api";
import type { Hello, MachineInfo } from "../net/protocol";
import { ActorSelection } from "./actorSelection";
import { Event } from "./signal";

export class MachineReader extends ActorSelection {
  readonly notices = new Event<string>();
  /** The id of the watched stage. */
  stage = "";
  private playedVersion: number | undefined;

  protected forgetPast(): void {
    this.history.clear();
    this.eventLog.clear();
  }

  /** Fetches the machine, the stage's history and, if the page knows nothing of it yet, its log. */
  protected async learn(hello: Hello, restarted: boolean): Promise<void> {
    await this.loadMachine();
    const { stage } = hello;
    if (stage !== this.stage) return;
    await api.history(stage).then(
      (past) => this.recall(stage, past),
      () => undefined,
    );
    if (!restarted || stage !== this.stage) return;
    await api.log(stage).then(
      (entries) => stage === this.stage && this.eventLog.remember(entries, hello.tick),
      () => undefined,
    );
  }

  /** Fetches the watched actor's machine, unless it is already here in the version that the stage plays. */
  async loadMachine(): Promise<void> {
    const { machine: name, version } = this.cast ?? {};
    const known = this.machine.value;
    if (name === undefined || (name === known?.name && version === this.playedVersion)) return;
    await api.machine(name).then(
      (machine) => name === this.cast?.machine && this.takeMachine(machine, version),
      (error: Error) => this.notices.emit(error.message),
    );
  }

  /**
   * Shows `machine`, unless a newer version is already shown; `played`: the version in the stage's own count.
   */
  takeMachine(machine: MachineInfo, played = this.playedVersion): void {
    this.playedVersion = played;
    const known = this.machine.value;
    if (known?.name === machine.name && known.version >= machine.version) return;
    if (known?.name !== machine.name || this.layer.value >= machine.layers.length) this.layer.set(0);
    this.machine.set(machine);
  }
}
