/** What the page knows of the stage it watches, and what it can ask of it. The panels and the picture read from here. */

import * as api from "./net/api";
import { Connection, type Link } from "./net/connection";
import { type GlbChunks, chunksOf, tickOf } from "./net/glb";
import { Meter, RoundTrip } from "./net/meter";
import type { Action, EventKind, FrameKind, Hello, MachineInfo, Refused, ServerMessage, Status, Verdict } from "./net/protocol";
import type { Handed } from "./net/relay";
import { type PoseFrame, isGlb, readPoseFrame } from "./net/wire";
import { blendTicks } from "./blendticks";
import { lineOf } from "./history";
import { Lookback } from "./lookback";
import { Bell, Signal } from "./store";
import { Watched } from "./watched";

export class Session extends Watched {
  readonly link = new Signal<{ state: Link; detail: string }>({ state: "connecting", detail: "" });
  readonly status = new Signal<Pick<Status, "paused" | "speed" | "viewers">>({ paused: false, speed: 1, viewers: 1 });
  readonly frames = new Signal<FrameKind>("pose");
  private readonly back = new Lookback((message) => this.connection.send(message));
  /** The tick this page looks at, or null while it follows the stage. */
  readonly looking = this.back.looking;
  readonly verdicts = new Bell<Verdict>();
  readonly actions = new Bell<Action>();
  readonly notices = new Bell<string>();
  /** This page is about to leave its stage: what it holds there has to be let go of. */
  readonly leaving = new Bell<null>();
  readonly received = new Meter();
  readonly trip = new RoundTrip();
  /** The newest frame that was not drawn yet. */
  pose: PoseFrame | null = null;
  glb: GlbChunks | null = null;
  tick = 0;
  head = 0;
  first = 0;
  hash = "";
  stage = "";
  private playedVersion: number | undefined;
  private lastPhase: number | null = null;
  private refs = 1;
  private readonly connection: Connection;

  constructor() {
    super();
    this.connection = new Connection({
      link: (state, detail) => {
        if (state === "lost") this.history.tear();
        this.link.set({ state, detail });
      },
      message: (message) => this.hear(message),
      frame: (handed) => this.take(handed),
      failed: () => void this.findStage(),
    });
  }

  /** Leaves the stage it was at and watches `stage`. */
  watch(stage: string): void {
    this.leaving.ring(null);
    this.stage = stage;
    this.forgetPast();
    this.back.forget();
    this.state.set(null);
    this.pose = this.glb = null;
    this.connection.connect(stage, () => this.frames.value);
  }

  private forgetPast(): void {
    this.history.clear();
    this.happenings.clear();
  }

  retry(): void {
    this.connection.retryNow();
  }

  /** How far the watched actor's motion is, 0…1; null where the stream does not say. */
  phase(): number | null {
    return this.frames.value === "pose" ? this.lastPhase : null;
  }

  private take({ frame, skipped, skippedBytes }: Handed): void {
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
    // The GLB carries no states: the last one known goes on until a verdict says otherwise.
    const live = this.looking.value === null;
    if (live) this.layerStates.value.forEach((state, layer) => this.history.see(lineOf(actor, layer), tick, state));
    else this.tellStates((this.cast?.layers ?? []).map((_, layer) => this.history.stateAt(lineOf(actor, layer), tick) ?? ""));
    const base = this.stateIndex(actor, this.layerStates.value[0] ?? "");
    this.state.set(base >= 0 ? base : null);
  }

  private moved(tick: number, head: number): void {
    this.tick = tick;
    this.head = Math.max(this.head, head);
    this.back.arrived(tick);
  }

  private hear(message: ServerMessage): void {
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
    this.back.refused();
    this.notices.ring(detail ?? title ?? "refused");
  }

  private greet(hello: Hello): void {
    const same = hello.stage === this.hello.value?.stage;
    const restarted = !same || hello.head < this.head;
    if (restarted) this.forgetPast();
    // A server that was started again may have read another table.
    if (same && restarted) this.machine.set(null);
    this.stage = hello.stage;
    Object.assign(this, { tick: hello.tick, head: hello.head, first: hello.first });
    this.status.set({ paused: hello.paused, speed: hello.speed, viewers: this.status.value.viewers });
    this.hello.set(hello);
    if (!this.place()) this.actor.set(hello.casts[0]?.actors[0]?.id ?? null);
    if (restarted) this.back.forget();
    else this.back.again();
    void this.learn(hello, restarted);
  }

  private async learn(hello: Hello, restarted: boolean): Promise<void> {
    await this.loadMachine();
    const { stage } = hello;
    await api.history(stage).then((told) => this.recall(stage, told), () => undefined);
    if (!restarted) return;
    await api.log(stage).then((entries) => stage === this.stage && this.happenings.remember(entries, hello.tick), () => undefined);
  }

  /** Fetches the machine of the watched actor, unless it is there in the version that the stage plays. */
  async loadMachine(): Promise<void> {
    const { machine: name, version } = this.cast ?? {};
    const known = this.machine.value;
    if (name === undefined || (name === known?.name && version === this.playedVersion)) return;
    await api.machine(name).then((machine) => this.takeMachine(machine, version), (error: Error) => this.notices.ring(error.message));
  }

  /** Shows `machine`, unless a newer version of it is there; `played`: the version by the stage's own count. */
  takeMachine(machine: MachineInfo, played = this.playedVersion): void {
    this.playedVersion = played;
    const known = this.machine.value;
    if (known?.name === machine.name && known.version >= machine.version) return;
    if (known?.name !== machine.name || this.layer.value >= machine.layers.length) this.layer.set(0);
    this.machine.set(machine);
  }

  private report({ head, first, paused, speed, viewers }: Status): void {
    Object.assign(this, { head: Math.max(head, this.head), first });
    const old = this.status.value;
    if (old.paused !== paused || old.speed !== speed || old.viewers !== viewers) this.status.set({ paused, speed, viewers });
  }

  private judge(verdict: Verdict): void {
    const { actor, layer, tick, to } = verdict;
    const rate = this.hello.value?.rate ?? 60;
    this.happenings.judge(verdict, this.place(actor) && this.cast?.machine === this.machine.value?.name ? blendTicks(this.machine.value, verdict, rate) : 0);
    const led = verdict.verdict === "taken" && to ? this.stateIndex(actor, to, layer) : -1;
    if (led >= 0) this.history.see(lineOf(actor, layer), tick, to!);
    if (actor !== this.actor.value) return;
    if (this.frames.value === "glb" && this.looking.value === null && led >= 0) this.leads(layer, led, to!);
    // Who looks back sees the past: what fires now is for later.
    if (this.looking.value === null) this.verdicts.ring(verdict);
  }

  private act(action: Action): void {
    this.happenings.act(action);
    if (this.looking.value === null) this.actions.ring(action);
  }

  private fork(stage: string): void {
    this.notices.ring(`An event in the past: this is now a fork, stage ${stage}.`);
    this.watch(stage);
  }

  private async findStage(): Promise<void> {
    const gone = await api.stage(this.stage).then(() => false, (error: unknown) => error instanceof api.ApiError && error.status === 404);
    if (!gone || this.stage === "main") return;
    this.notices.ring(`Stage ${this.stage} is gone: back to main.`);
    this.watch("main");
  }

  /** Sends an event of the watched actor's machine; in the past it makes a fork. */
  event(kind: EventKind, event: string): void {
    const actor = this.actor.value;
    if (actor === null) return;
    const past = this.looking.value === null ? {} : { tick: this.looking.value };
    this.connection.send({ type: "event", kind, actor, event, ref: `event ${this.refs++}`, ...past });
  }

  ping(): void {
    this.connection.send({ type: "ping", ref: this.trip.ask(performance.now()) });
  }

  /** Shows tick `tick` on this page alone. */
  look(tick: number): void {
    this.back.look(Math.round(Math.min(this.head, Math.max(this.first, tick))));
  }

  live(): void {
    this.back.live();
  }

  stream(frames: FrameKind): void {
    if (frames === this.frames.value) return;
    this.pose = this.glb = null;
    this.frames.set(frames);
    this.connection.send({ type: "frames", frames });
  }

  /** Runs a REST request on the stage; a refusal is shown. */
  async command(request: (stage: string) => Promise<unknown>): Promise<void> {
    await request(this.stage).catch((error: Error) => this.notices.ring(error.message));
  }
}
