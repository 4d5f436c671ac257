/** What this page knows of the stage's past: the runs of states, and the events of its actors. */

import * as api from "../net/api";
import type { Action, Hello, StateHistory, Verdict } from "../net/protocol";
import type { CastFrame } from "../net/wire";
import { blendTicks } from "./blendTicks";
import { EventLog } from "./eventLog";
import { History, laneKey } from "./history";
import type { Selection } from "./selection";
import type { WatchedMachine } from "./watchedMachine";
import type { WatchedStage } from "./watchedStage";

export class Past {
  readonly runs = new History();
  readonly events = new EventLog();
  /** Counts what the page has learned of the past. The timeline draws again when it grows, also while the stage is paused. */
  learned = 0;

  constructor(
    private readonly stage: WatchedStage,
    private readonly selection: Selection,
    private readonly machine: WatchedMachine,
  ) {}

  forget(): void {
    this.runs.clear();
    this.events.clear();
    this.learned++;
  }

  /** Fetches the stage's history and, if the page knows nothing of it yet, its log. */
  async learn({ stage, tick }: Hello, withLog: boolean): Promise<void> {
    const isWatched = (): boolean => stage === this.stage.id;
    if (!isWatched()) return;
    const history = await api.history(stage).catch(() => null);
    if (history && isWatched()) this.recall(history);
    if (!withLog || !isWatched()) return;
    const log = await api.log(stage).catch(() => null);
    if (log && isWatched()) this.events.remember(log, tick);
    this.learned++;
  }

  /** Enters the server's state changes. */
  private recall({ head, changes }: StateHistory): void {
    const lanes = new Map<number, { tick: number; state: string }[]>();
    for (const { actor, layer, tick, state } of changes) {
      const lane = laneKey(actor, layer);
      if (lanes.get(lane)?.push({ tick, state }) === undefined) lanes.set(lane, [{ tick, state }]);
    }
    lanes.forEach((known, lane) => this.runs.fill(lane, known, head));
    this.learned++;
  }

  /** Enters the states of every actor of cast number `c`. */
  see(tick: number, { state, layers }: CastFrame, c: number): void {
    const cast = this.stage.hello.value?.casts[c];
    cast?.actors.forEach(({ id }, row) => {
      for (let layer = 0; layer < layers; layer++)
        this.runs.see(laneKey(id, layer), tick, cast.states[state[row * layers + layer]!] ?? "");
    });
  }

  /** Enters a verdict; returns the index of the state that it leads to, or -1. */
  judge(verdict: Verdict): number {
    const { actor, layer, tick, to } = verdict;
    this.learned++;
    const known = this.selection.place(actor) !== null && this.machine.isActors;
    this.events.judge(verdict, known ? blendTicks(this.machine.info.value, verdict, this.stage.rate) : 0);
    const led = verdict.verdict === "taken" && to ? this.selection.stateIndex(actor, to, layer) : -1;
    if (led >= 0) this.runs.enter(laneKey(actor, layer), tick, to);
    return led;
  }

  /** Enters an action. */
  act(action: Action): void {
    this.events.act(action);
    this.learned++;
  }

  /** Ticks from `from` to `to` in which `actor` entered a state or got a verdict. */
  happened(actor: number, from: number, to: number): number[] {
    const layers = this.selection.cast?.layers ?? [];
    const entered = layers.flatMap((_, layer) =>
      this.runs.between(laneKey(actor, layer), from, to).map((run) => run.start),
    );
    const judged = this.events
      .marksBetween(actor, from, to)
      .filter(({ kind }) => kind !== "logged")
      .map((mark) => mark.tick);
    return [...entered.filter((tick) => tick >= from), ...judged];
  }
}
