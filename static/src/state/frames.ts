/** The stream of frames: its kind, and the newest frame until it is drawn. */

import { signal } from "@preact/signals-core";
import { type GlbChunks, chunksOf, tickOf } from "../net/glb";
import { Meter } from "../net/meter";
import type { FrameKind, Skinning } from "../net/protocol";
import type { Delivery } from "../net/relay";
import { type PoseFrame, isGlb, readPoseFrame } from "../net/wire";
import { laneKey } from "./history";
import type { Line } from "./line";
import type { Past } from "./past";
import type { Playback } from "./playback";
import type { Selection } from "./selection";
import type { WatchedStage } from "./watchedStage";

export class Frames {
  readonly kind = signal<FrameKind>("pose");
  /** The way of skinning of all characters, or null: each its own. */
  readonly skinning = signal<Skinning | null>(null);
  readonly received = new Meter();
  /** The newest frame of each stream, until it is drawn. */
  pose: PoseFrame | null = null;
  glb: GlbChunks | null = null;
  private lastPhase: number | null = null;

  constructor(
    private readonly line: Line,
    private readonly stage: WatchedStage,
    private readonly selection: Selection,
    private readonly past: Past,
    private readonly playback: Playback,
  ) {
    line.frames.on((delivery) => this.take(delivery));
  }

  /** Returns the phase of the watched actor's motion, 0…1, or null if the stream does not carry it. */
  phase(): number | null {
    return this.kind.value === "pose" ? this.lastPhase : null;
  }

  /** Drops what waits to be drawn. */
  drop(): void {
    this.pose = this.glb = null;
  }

  /** Chooses which frames the server sends. */
  stream(kind: FrameKind): void {
    if (kind === this.kind.value) return;
    this.drop();
    this.kind.value = kind;
    this.choose();
  }

  /** Chooses the way of skinning. */
  skin(skinning: Skinning | null): void {
    this.skinning.value = skinning;
    if (this.kind.value === "glb") this.choose();
  }

  private choose(): void {
    this.line.send({ type: "frames", frames: this.kind.value, skinning: this.skinning.value });
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
    if (frame.epoch !== this.stage.hello.value?.epoch) return;
    this.pose = frame;
    this.stage.hash = frame.hash;
    this.moved(frame.tick, frame.head);
    frame.casts.forEach((cast, c) => this.past.see(frame.tick, cast, c));
    const place = this.selection.place();
    const cast = place && frame.casts[place.cast];
    if (cast) this.selection.showStates(cast, place.row);
    this.lastPhase = cast ? (cast.phase[place.row * cast.layers] ?? null) : null;
  }

  private takeGlb(buffer: ArrayBuffer): void {
    this.glb = chunksOf(buffer);
    const tick = tickOf(this.glb);
    if (tick === null) return;
    this.moved(tick, this.playback.isLive ? tick : this.stage.head);
    const { actor, layerStates, state } = this.selection;
    if (actor.value === null) return;
    if (this.playback.isLive && layerStates.value.some(Boolean)) this.lasts(actor.value, tick);
    else this.selection.tellStates(this.statesAt(actor.value, tick));
    const base = this.selection.stateIndex(actor.value, layerStates.value[0] ?? "");
    state.value = base >= 0 ? base : null;
  }

  /** A GLB frame carries no states: the last state goes on until a verdict changes it. */
  private lasts(actor: number, tick: number): void {
    this.selection.layerStates.value.forEach((state, layer) =>
      this.past.runs.see(laneKey(actor, layer), tick, state),
    );
  }

  private statesAt(actor: number, tick: number): string[] {
    const { runs } = this.past;
    return (this.selection.cast?.layers ?? []).map((_, layer) => {
      const lane = laneKey(actor, layer);
      return (this.playback.isLive ? runs.newest(lane) : runs.stateAt(lane, tick)) ?? "";
    });
  }

  private moved(tick: number, head: number): void {
    this.stage.moved(tick, head);
    this.playback.scrubber.arrived(tick);
  }
}
