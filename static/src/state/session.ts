/** Watches a stage: hears its messages, passes them on to the parts of the state, and sends commands. */

import { signal } from "@preact/signals-core";
import * as api from "../net/api";
import { RoundTrip } from "../net/meter";
import type {
  Access,
  Action,
  EventKind,
  Hello,
  Refused,
  ServerMessage,
  Status,
  Verdict,
} from "../net/protocol";
import { reasonOf } from "../net/reason";
import { Event } from "./event";
import { Inputs } from "./inputs";
import type { Frames } from "./frames";
import type { Line } from "./line";
import type { Notice } from "./notice";
import type { Past } from "./past";
import type { Playback } from "./playback";
import type { Selection } from "./selection";
import type { WatchedMachine } from "./watchedMachine";
import type { WatchedStage } from "./watchedStage";

const FULL =
  "This stage has as many viewers as it may have. The page tries again; choose a machine for a stage of your own.";

/** The parts of the state that a session keeps up to date. */
export interface SessionParts {
  line: Line;
  stage: WatchedStage;
  selection: Selection;
  machine: WatchedMachine;
  past: Past;
  playback: Playback;
  frames: Frames;
  notices: Event<Notice>;
}

export class Session {
  /** What this browser may do, or null while the page does not know. */
  readonly access = signal<Access | null>(null);
  /** The verdicts of the watched actor, while the page is live. */
  readonly verdicts = new Event<Verdict>();
  readonly actions = new Event<Action>();
  /** Emitted with the stage that an event in the past has made, before this page watches it. */
  readonly forked = new Event<string>();
  /** Emitted if the server has closed the stage, or shows this browser only another one, before this page watches that. */
  readonly gone = new Event<null>();
  /** Emitted before this page leaves its stage: held events must be released. */
  readonly leaving = new Event<null>();
  readonly trip = new RoundTrip();
  /** When the newest message came that is no frame; the server sends one a second at least. */
  heardAt = 0;
  /** The stage, and the tick at which it came back, of the newest notice about it. */
  private toldRestored = "";
  /** Whether the user knows, since the line was last live, that the stage is full. */
  private toldFull = false;
  readonly inputs: Inputs;
  /** The fork that the page goes to. */
  private forking = "";

  constructor(private readonly parts: SessionParts) {
    const { line, past } = parts;
    this.inputs = new Inputs(parts);
    line.messages.on((message) => this.hear(message));
    line.failed.on(() => void this.findStage());
    line.link.subscribe(({ state }) => {
      if (state === "lost") past.runs.markGap();
      if (state !== "live") return;
      this.toldFull = false;
      void this.readAccess();
    });
  }

  /** Leaves the present stage and watches `stage`. */
  watch(stage: string): void {
    const { line, past, playback, selection, frames } = this.parts;
    this.leaving.emit(null);
    this.parts.stage.id = stage;
    past.forget();
    playback.scrubber.forget();
    selection.forgetStates();
    frames.drop();
    line.connect(
      stage,
      () => frames.kind.value,
      () => frames.skinning.value,
    );
  }

  private hear(message: ServerMessage): void {
    this.heardAt = performance.now();
    if (message.type === "hello") this.greet(message);
    else if (message.type === "status") this.report(message);
    else if (message.type === "verdict") this.judge(message);
    else if (message.type === "action") this.act(message);
    else if (message.type === "accepted") this.accepted(message.stage);
    else if (message.type === "forked") this.fork(message.stage);
    else if (message.type === "pong") this.trip.answer(message.ref, performance.now());
    else if (message.type === "error") this.refused(message);
  }

  private refused({ ref, title, detail }: Refused): void {
    if (this.trip.answer(ref, performance.now())) return;
    this.inputs.forget();
    this.parts.playback.scrubber.refused();
    this.parts.notices.emit(detail || title);
  }

  private greet(hello: Hello): void {
    const { stage, past, machine, selection, playback } = this.parts;
    const same = hello.stage === stage.hello.value?.stage;
    const restarted = !same || hello.head < stage.head;
    if (restarted) past.forget();
    if (same && restarted) machine.doubt();
    this.tellTrouble(hello);
    stage.greet(hello);
    this.tellRestored(hello);
    if (hello.stage === this.forking) this.inputs.sendWaiting();
    this.inputs.forget();
    selection.settle();
    if (restarted) playback.scrubber.forget();
    else playback.scrubber.again();
    void machine.load().then(() => past.learn(hello, restarted));
  }

  /** Says it once, and within a minute of the restart: later it is no news. */
  private tellRestored({ stage, restored, head, rate }: Hello): void {
    const key = `${stage} ${restored}`;
    if (restored === null || key === this.toldRestored || head - restored > 60 * rate) return;
    this.toldRestored = key;
    this.parts.notices.emit(
      `Restored: the server was started again, and stage ${stage} goes on at tick ${restored}.`,
    );
  }

  private report(status: Status): void {
    this.tellTrouble(status);
    this.parts.stage.report(status);
  }

  private tellTrouble({ trouble }: Status | Hello): void {
    const before = this.parts.stage.status.value.trouble;
    if (trouble && trouble !== before) this.parts.notices.emit(`Nothing is kept now: ${trouble}.`);
    if (before && !trouble) this.parts.notices.emit("Everything is kept again.");
  }

  private judge(verdict: Verdict): void {
    const { past, selection, frames, playback } = this.parts;
    const led = past.judge(verdict);
    // While the past is shown, present verdicts stay out of the panels.
    if (verdict.actor !== selection.actor.value || !playback.isLive) return;
    if (frames.kind.value === "glb" && led >= 0) selection.leads(verdict.layer, led, verdict.to);
    this.verdicts.emit(verdict);
  }

  private act(action: Action): void {
    this.parts.past.act(action);
    if (this.parts.playback.isLive) this.actions.emit(action);
  }

  /** An event that was sent to the newest tick makes no fork. */
  private accepted(stage: string): void {
    if (stage === this.parts.stage.id) this.inputs.sendWaiting();
  }

  private fork(stage: string): void {
    const origin = this.parts.stage.id;
    this.parts.notices.emit({
      text: "You sent an event to the past: you now watch a fork.",
      words: `back to ${origin}`,
      act: () => this.watch(origin),
    });
    this.forking = stage;
    this.forked.emit(stage);
    this.watch(stage);
  }

  private async findStage(): Promise<void> {
    const { id } = this.parts.stage;
    const refusal = await api.stage(id).then(
      ({ full }) => {
        if (full) this.awaitRoom();
        return null;
      },
      (error: unknown) => (error instanceof api.ApiError ? error : null),
    );
    if (refusal?.status === 401) this.parts.line.refuse(refusal.message);
    if (refusal?.status === 403) await this.findShared(refusal.message);
    if (refusal?.status !== 404 || id === "main") return;
    this.parts.notices.emit(`Stage ${id} is gone: you now watch main.`);
    this.gone.emit(null);
    this.watch("main");
  }

  private awaitRoom(): void {
    this.parts.line.awaitRoom(FULL);
    if (!this.toldFull) this.parts.notices.emit(FULL);
    this.toldFull = true;
  }

  /** Watches the one stage that this browser may watch; `detail` says why not the present one. */
  private async findShared(detail: string): Promise<void> {
    await this.readAccess();
    const stage = this.access.value?.stage ?? null;
    if (stage === null || stage === this.parts.stage.id) {
      this.parts.line.refuse(detail);
      return;
    }
    this.gone.emit(null);
    this.watch(stage);
  }

  private async readAccess(): Promise<void> {
    this.access.value = await api.access().catch(() => this.access.value);
  }

  /** Sends an event to the watched actor; in the past it makes a fork. */
  event(kind: EventKind, event: string): void {
    this.inputs.sender()({ kind, event });
  }

  ping(): void {
    this.parts.line.send({ type: "ping", ref: this.trip.ask(performance.now()) });
  }

  /** Runs a REST request on the stage, as its viewer with this page's number; a refusal is shown. */
  async command(request: (stage: string, viewer?: number) => Promise<unknown>): Promise<void> {
    const { id, hello } = this.parts.stage;
    await request(id, hello.value?.viewer).catch((error: unknown) =>
      this.parts.notices.emit(reasonOf(error)),
    );
  }
}
