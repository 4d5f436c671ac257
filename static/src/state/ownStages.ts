/** Opens stages for this page, and closes them when the page leaves them; forks and their origins stay. */

import * as api from "../net/api";
import { fork } from "../net/stages";
import { reasonOf } from "../net/reason";
import type { Event } from "./event";
import type { Notice } from "./notice";
import type { Session } from "./session";
import type { WatchedStage } from "./watchedStage";

/** What a stage begins with: one actor of a machine, or a scene. */
export type Opening = { machine: string } | { scene: string };

export class OwnStages {
  /** The stages that this page made. */
  private readonly made = new Map<string, Opening>();
  /** Stages to close as soon as the page has another one. */
  private left: string[] = [];
  private choices = 0;
  /** Settles when the stages that the page left last are closed: their machines are free then. */
  closed: Promise<unknown> = Promise.resolve();

  constructor(
    private readonly session: Session,
    private readonly stage: WatchedStage,
    private readonly notices: Event<Notice>,
  ) {
    session.forked.on(() => this.keep());
    session.leaving.on(() => this.leave());
    stage.hello.subscribe((hello) => {
      if (hello) this.close();
    });
  }

  /**
   * Watches the stage that the address names, or main. A stage that this tab made is its own again after a
   * reload; if the server has closed it meanwhile, a new one is opened, also of what a link names (`linked`).
   */
  async begin(stage: string | null, linked: Opening | null = null): Promise<void> {
    const own = history.state as Opening | null;
    const opening = own ?? linked;
    if (!opening) {
      this.choices++;
      this.session.watch(stage ?? "main");
      return;
    }
    const choice = ++this.choices;
    const stages = await api.stages().catch(() => []);
    if (choice !== this.choices) return;
    if (stage === null || !stages.some(({ id }) => id === stage)) return this.open(opening);
    if (own) this.made.set(stage, own);
    this.session.watch(stage);
  }

  /** Watches a new stage that the address names; if the server refuses it, says why, and watches main. */
  private async open(opening: Opening): Promise<void> {
    const choice = this.choices + 1;
    try {
      await this.choose(opening, Promise.resolve(false));
    } catch (error) {
      if (choice !== this.choices) return;
      this.notices.emit({ text: reasonOf(error), words: "try again", act: () => void this.open(opening) });
      this.session.watch("main");
    }
  }

  /** Watches main if it shows `opening` already, else a new stage; the last choice counts. */
  async choose(opening: Opening, onMain: Promise<boolean>): Promise<void> {
    const choice = ++this.choices;
    const stage = (await onMain) ? "main" : await api.newStage(opening);
    if (stage !== "main") this.made.set(stage, opening);
    if (choice === this.choices) this.session.watch(stage);
    else await this.remove(stage);
  }

  /** Forks the watched stage at `tick`, by default at its newest, and watches the fork. */
  async fork(tick: number | null, name: string): Promise<void> {
    const origin = this.stage.id;
    const made = await fork(origin, tick, name);
    if (this.stage.id === origin) this.keep();
    this.session.watch(made.id);
  }

  /** Deletes a stage; a page that watches it goes to `next` before. */
  async discard(stage: string, next: string): Promise<void> {
    this.made.delete(stage);
    if (this.stage.id === stage) this.session.watch(next);
    await api.remove(stage);
  }

  /** Watches a stage that this page has made. */
  show(stage: string, opening: Opening): void {
    this.choices++;
    this.made.set(stage, opening);
    this.session.watch(stage);
  }

  /** Returns what a stage of this page began with, or null. */
  openingOf(stage: string): Opening | null {
    return this.made.get(stage) ?? null;
  }

  /** Keeps the watched stage, also if Back and Forward lead to it again and away. */
  private keep(): void {
    this.made.delete(this.stage.id);
    history.replaceState(null, "");
  }

  /** Notes that the page leaves its stage, unless somebody else watches it too. */
  private leave(): void {
    if (this.stage.status.value.viewers <= 1) this.left.push(this.stage.id);
  }

  private close(): void {
    const left = this.left.filter((stage) => stage !== this.stage.id);
    this.left = [];
    this.closed = Promise.all(left.map((stage) => this.remove(stage)));
  }

  private async remove(stage: string): Promise<void> {
    if (this.made.delete(stage)) await api.remove(stage).catch(() => undefined);
  }
}
