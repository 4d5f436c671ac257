/** The machines and scenes that the server offers, and how this page opens one. */

import { signal } from "@preact/signals-core";
import * as api from "../net/api";
import type { Clip, MachineSummary, SceneSummary } from "../net/protocol";
import type { OwnStages } from "./ownStages";
import type { Session } from "./session";

export class Library {
  readonly machines = signal<readonly MachineSummary[]>([]);
  readonly scenes = signal<readonly SceneSummary[]>([]);
  private readonly clips = signal<ReadonlyMap<string, readonly Clip[]>>(new Map());

  private readonly reading = new Map<string, Promise<readonly Clip[]>>();

  constructor(
    private readonly session: Session,
    private readonly stages: OwnStages,
  ) {}

  /** Asks the server again. */
  async read(): Promise<void> {
    [this.machines.value, this.scenes.value] = await Promise.all([
      api.machines().catch(() => []),
      api.scenes().catch(() => []),
    ]);
  }

  /** Returns the clips of a character; asks the server the first time, and has none until it answers. */
  clipsOf(character: string): readonly Clip[] {
    const clips = this.clips.value.get(character);
    if (!clips && character) void this.readClips(character);
    return clips ?? [];
  }

  private async readClips(character: string): Promise<void> {
    const clips = this.reading.get(character) ?? api.character(character).then((whole) => whole.clips);
    this.reading.set(character, clips);
    const known = await clips.catch(() => []);
    if (!this.clips.value.has(character)) this.clips.value = new Map(this.clips.value).set(character, known);
  }

  /** Returns the scene of a machine, or "". */
  sceneOf(machine: string): string {
    return this.machines.value.find(({ name }) => name === machine)?.scene ?? "";
  }

  /** Watches a machine: on the main stage if it plays there, else on a new stage. */
  async openMachine(machine: string): Promise<void> {
    const isIt = (name: string): boolean => name === machine;
    await this.session.command(() => this.stages.choose({ machine }, this.onMain(isIt)));
  }

  /** Watches a scene, as `openMachine` does. */
  async openScene(scene: string): Promise<void> {
    const isIn = (name: string): boolean => this.sceneOf(name) === scene;
    await this.session.command(() => this.stages.choose({ scene }, this.onMain(isIn)));
  }

  private async onMain(matches: (machine: string) => boolean): Promise<boolean> {
    const main = await api.stage("main").catch(() => null);
    return main?.actors.some(({ machine }) => matches(machine)) ?? false;
  }
}
