/** Holds the state of the watched stage and sends commands to it. Views and panels read from here. */

import * as api from "../net/api";
import { Connection, type Link } from "../net/connection";
import { type GlbChunks, chunksOf, tickOf } from "../net/glb";
import { Meter, RoundTrip } from "../net/meter";
import type {
  Access,
  Action,
  EventKind,
  FrameKind,
  Hello,
  Refused,
  Skinning,
  ServerMessage,
  Status,
  Verdict,
} from "../net/protocol";
import type { Delivery } from "../net/relay";
import { type PoseFrame, isGlb, readPoseFrame } from "../net/wire";
import { blendTicks } from "./blendTicks";
import { laneKey } from "./history";
import { Scrubber } from "./scrubber";
import { Event, Signal } from "./signal";
import { MachineReader } from "./machineReader";

export class Session extends MachineReader {
  readonly link = new Signal<{ state: Link; detail: string }>({ state: "connecting", detail: "" });
  /** What this browser may do, or null while the page does not know. */
  readonly access = new Signal<Access | null>(null);
  readonly status = new Signal<Pick<Status, "paused" | "speed" | "viewers" | "pace" | "trouble">>({
    paused: false,
    speed: 1,
    viewers: 1,
    pace: 1,
    trouble: "",
  });
  readonly frames = new Signal<FrameKind>("pose");
  /** The way of skinning of all characters, or null: each its own. */
  readonly skinning = new Signal<Skinning | null>(null);
  private readonly scrubber = new Scrubber((message) => this.connection.send(message));
  /** The past tick that this page shows, or null while it follows the stage. */
  readonly looking = this.scrubber.looking;
  readonly verdicts = new Event<Verdict>();
  readonly actions = new Event<Action>();
  /** Emitted with the stage that an event in the past has made, before this page watches it. */
  readonly forked = new Event<string>();
  /** Emitted before this page leaves its stage: held events must be released. */
  readonly leaving = new Event<null>();
  readonly received = new Meter();
  readonly trip = new RoundTrip();
  /** When the newest message came that is no frame; the server sends one a second at least. */
  heardAt = 0;
  /** The newest frame of each stream, until it is drawn. */
  pose: PoseFrame | null = null;
  glb: GlbChunks | null = null;
  tick = 0;
  head = 0;
  first = 0;
  hash = "";
  private lastPhase: number | null = null;
  /** The stage, and the tick at which it came back, of the newest notice about it. */
  private toldRestored = "";
  private refs = 1;
  readonly connection: Connection;

  constructor() {
    super();
    this.connection = new Connection({
      link: (state, detail) => {
        if (state === "lost") this.history.markGap();
        this.link.set({ state, detail });
        if (state === "live") void this.readAccess();
      },
      message: (message) => this.hear(message),
      frame: (delivery) => this.take(delivery),
      failed: () => void this.findStage(),
    });
  }

  /** Leaves the present stage and watches `stage`. */
  watch(stage: string): void {
    this.leaving.emit(null);
    this.stage = stage;
    this.forgetPast();
    this.scrubber.forget();
    this.state.set(null);
    this.tellStates([]);
    this.pose = this.glb = null;
    this.connection.connect(
      stage,
      () => this.frames.value,
      () => this.skinning.value,
    );
  }

  retry(): void {
    this.connection.retryNow();
  }

  /** Returns the phase of the watched actor's motion, 0…1, or null if the stream does not carry it. */
  phase(): number | null {
    return this.frames.value === "pose" ? this.lastPhase : null;
  }

  private take({ frame, skipped, skippedBytes }: Delivery): void {
    const now = performance.now();
    this.received.add(now, frame.byteLength);
    for (let i = 0; i < skipped; i++) this.received.add(now, skippedBytes / skipped);
    if (isGlb(frame)) this.takeGlb(frame);
    else this.takePose(frame);
  }

  private takePose(buffer: ArrayBuffer): void {
    const frame = readPoseFrame(buffer);
    if (frame.epoch !== this.hello.value?.epoch) return;
    this.pose = frame;
    this.hash = frame.hash;
    this.moved(frame.tick, frame.head);
    frame.casts.forEach((cast, c) => this.remember(frame.tick, cast, c));
    const place = this.place();
    const cast = place && frame.casts[place.cast];
    if (cast) this.showStates(cast, place.row);
    this.lastPhase = cast ? (cast.phase[place.row * cast.layers] ?? null) : null;
  }

  private takeGlb(buffer: ArrayBuffer): void {
    this.glb = chunksOf(buffer);
    const tick = tickOf(this.glb);
    if (tick === null) return;
    this.moved(tick, this.looking.value === null ? tick : this.head);
    const actor = this.actor.value;
    if (actor === null) return;
    // A GLB frame carries no states: the last state goes on until a verdict changes it.
    const live = this.looking.value === null;
    if (live && this.layerStates.value.some(Boolean))
      this.layerStates.value.forEach((state, layer) => this.history.see(laneKey(actor, layer), tick, state));
    else
      this.tellStates(
        (this.cast?.layers ?? []).map((_, layer) => {
          const lane = laneKey(actor, layer);
          return (live ? this.history.newest(lane) : this.history.stateAt(lane, tick)) ?? "";
        }),
      );
    const base = this.stateIndex(actor, this.layerStates.value[0] ?? "");
    this.state.set(base >= 0 ? base : null);
  }

  private moved(tick: number, head: number): void {
    this.tick = tick;
    this.head = Math.max(this.head, head);
    this.scrubber.arrived(tick);
  }

  private hear(message: ServerMessage): void {
    this.heardAt = performance.now();
    if (message.type === "hello") this.greet(message);
    else if (message.type === "status") this.report(message);
    else if (message.type === "verdict") this.judge(message);
    else if (message.type === "action") this.act(message);
    else if (message.type === "forked") this.fork(message.stage);
    else if (message.type === "pong") this.trip.answer(message.ref, performance.now());
    else if (message.type === "error") this.refused(message);
  }

  private refused({ ref, title, detail }: Refused): void {
    if (this.trip.answer(ref, performance.now())) return;
    this.scrubber.refused();
    this.notices.emit(detail ?? title ?? "refused");
  }

  private greet(hello: Hello): void {
    const same = hello.stage === this.hello.value?.stage;
    const restarted = !same || hello.head < this.head;
    if (restarted) this.forgetPast();
    // The server may have read another table when it started again.
    if (same && restarted) this.machine.set(null);
    this.stage = hello.stage;
    Object.assign(this, { tick: hello.tick, head: hello.head, first: hello.first });
    this.learnStatus(hello);
    this.hello.set(hello);
    this.tellRestored(hello);
    if (!this.place()) this.actor.set(hello.casts[0]?.actors[0]?.id ?? null);
    if (restarted) this.scrubber.forget();
    else this.scrubber.again();
    void this.learn(hello, restarted);
  }

  /** Says it once, and within a minute of the restart: later it is no news. */
  private tellRestored({ stage, restored, head, rate }: Hello): void {
    const key = `${stage} ${restored}`;
    if (restored === null || key === this.toldRestored || head - restored > 60 * rate) return;
    this.toldRestored = key;
    this.notices.emit(`Restored: the server was started again, and this stage goes on at tick ${restored}.`);
  }

  private report(status: Status): void {
    Object.assign(this, { head: Math.max(status.head, this.head), first: status.first });
    this.learnStatus(status);
  }

  private learnStatus({ paused, speed, viewers, pace, trouble }: Status | Hello): void {
    const old = this.status.value;
    const now = { paused, speed, viewers, pace, trouble };
    if (JSON.stringify(old) !== JSON.stringify(now)) this.status.set(now);
    if (trouble && trouble !== old.trouble) this.notices.emit(`Nothing is kept now: ${trouble}.`);
    if (old.trouble && !trouble) this.notices.emit("Everything is kept again.");
  }

  private judge(verdict: Verdict): void {
    const { actor, layer, tick, to } = verdict;
    const rate = this.hello.value?.rate ?? 60;
    this.eventLog.judge(
      verdict,
      this.place(actor) && this.cast?.machine === this.machine.value?.name
        ? blendTicks(this.machine.value, verdict, rate)
        : 0,
    );
    const led = verdict.verdict === "taken" && to ? this.stateIndex(actor, to, layer) : -1;
    if (led >= 0) this.history.see(laneKey(actor, layer), tick, to!);
    if (actor !== this.actor.value) return;
    if (this.frames.value === "glb" && this.looking.value === null && led >= 0) this.leads(layer, led, to!);
    // While the past is shown, present verdicts stay out of the panels.
    if (this.looking.value === null) this.verdicts.emit(verdict);
  }

  private act(action: Action): void {
    this.eventLog.act(action);
    if (this.looking.value === null) this.actions.emit(action);
  }

  private fork(stage: string): void {
    this.notices.emit(`You sent an event to the past: you now watch a fork, stage ${stage}.`);
    this.forked.emit(stage);
    this.watch(stage);
  }

  private async findStage(): Promise<void> {
    const refusal = await api.stage(this.stage).then(
      () => null,
      (error: unknown) => (error instanceof api.ApiError ? error : null),
    );
    if (refusal?.status === 401) this.connection.refuse(refusal.message);
    if (refusal?.status === 403) await this.findShared(refusal.message);
    if (refusal?.status !== 404 || this.stage === "main") return;
    this.notices.emit(`Stage ${this.stage} is gone: you now watch main.`);
    this.watch("main");
  }

  /** Watches the one stage that this browser may watch; `detail` says why not the present one. */
  private async findShared(detail: string): Promise<void> {
    await this.readAccess();
    const stage = this.access.value?.stage ?? null;
    if (stage === null || stage === this.stage) return this.connection.refuse(detail);
    this.watch(stage);
  }

  private async readAccess(): Promise<void> {
    this.access.set(await api.access().catch(() => this.access.value));
  }

  /** Sends an event to the watched actor; in the past it makes a fork. */
  event(kind: EventKind, event: string): void {
    const actor = this.actor.value;
    if (actor === null) return;
    const past = this.looking.value === null ? {} : { tick: this.looking.value };
    this.connection.send({ type: "event", kind, actor, event, ref: `event ${this.refs++}`, ...past });
  }

  ping(): void {
    this.connection.send({ type: "ping", ref: this.trip.ask(performance.now()) });
  }

  /** Shows `tick` on this page only. */
  look(tick: number): void {
    this.scrubber.look(Math.round(Math.min(this.head, Math.max(this.first, tick))));
  }

  live(): void {
    this.scrubber.live();
  }

  stream(frames: FrameKind): void {
    if (frames === this.frames.value) return;
    this.pose = this.glb = null;
    this.frames.set(frames);
    this.choose();
  }

  skin(skinning: Skinning | null): void {
    this.skinning.set(skinning);
    if (this.frames.value === "glb") this.choose();
  }

  /** Tells the server which frames this page wants. */
  private choose(): void {
    this.connection.send({ type: "frames", frames: this.frames.value, skinning: this.skinning.value });
  }

  /** Runs a REST request on the stage; a refusal is shown. */
  async command(request: (stage: string) => Promise<unknown>): Promise<void> {
    await request(this.stage).catch((error: Error) => this.notices.emit(error.message));
  }
}
