/** The part of the history that the timeline shows, and the span of ticks that the user has selected in it. */

import { signal } from "@preact/signals-core";
import type { Playback } from "./playback";
import type { WatchedStage } from "./watchedStage";

/** Ticks, both included. */
export interface Span {
  from: number;
  to: number;
}

/** What is shown at first, seconds. */
const FIRST_S = 120;
/** The shortest window, ticks. */
const LEAST_TICKS = 20;

/**
 * Returns the shown span of the history `first`…`head`.
 * @param length Ticks; null: all.
 * @param end Its last tick; null: the newest.
 * @param looking The tick that the page shows, which stays inside; null: the newest.
 */
export function spanOf(
  first: number,
  head: number,
  length: number | null,
  end: number | null,
  looking: number | null,
): Span {
  const newest = Math.max(head, first + 1);
  if (length === null) return { from: first, to: newest };
  const last = Math.min(newest, Math.max(end ?? newest, first + length));
  const shift = looking === null ? 0 : Math.min(0, looking - (last - length)) + Math.max(0, looking - last);
  const to = Math.max(first + 1, last + shift);
  return { from: Math.max(first, to - length), to };
}

/** Returns a span `factor` times as long, in which the tick `at` stays where it is drawn. */
export function zoomed({ from, to }: Span, at: number, factor: number): Span {
  return { from: Math.round(at - (at - from) * factor), to: Math.round(at + (to - at) * factor) };
}

export class TimelineWindow {
  private readonly length = signal<number | null>(null);
  private readonly end = signal<number | null>(null);
  /** Whether the user has zoomed. */
  private isOwn = false;
  /** Where a span begins whose end is not marked yet. */
  private begun: number | null = null;
  /**
   * The newest tick when the page began to show the past; null: it shows the present. The timeline ends there, so that
   * nothing slides away under the pointer.
   */
  private stood: number | null = null;
  readonly selected = signal<Span | null>(null);
  /** What a selected span is compared with. */
  readonly kept = signal<Span | null>(null);
  /** Layers whose lanes show states alone, without blends and events. */
  readonly folded = signal<ReadonlySet<string>>(new Set());
  /** Events whose names have this text are shown; empty: all. */
  readonly filter = signal("");

  constructor(
    private readonly stage: WatchedStage,
    private readonly playback: Playback,
  ) {
    let watched = "";
    stage.hello.subscribe((hello) => {
      if (!hello || hello.stage === watched) return;
      watched = hello.stage;
      this.selected.value = this.kept.value = this.playback.loop.value = this.begun = null;
      // One lane with its events is read at a glance, four of them take the room of the table.
      this.folded.value = new Set(hello.casts.flatMap(({ layers }) => layers.slice(1)));
      this.recent();
    });
    playback.looking.subscribe((tick) => {
      this.stood = tick === null ? null : (this.stood ?? stage.head);
    });
  }

  get span(): Span {
    const { first, rate } = this.stage;
    const length = this.isOwn ? this.length.value : FIRST_S * rate;
    return spanOf(first, this.newest, length, this.end.value, this.playback.looking.value);
  }

  /** The tick at which the timeline ends. */
  private get newest(): number {
    if (this.stood === null) return this.stage.head;
    return Math.max(this.stood, this.playback.looking.value ?? 0, this.end.value ?? 0);
  }

  /** Whether all of the history is shown. */
  get isAll(): boolean {
    return this.isOwn && this.length.value === null;
  }

  /** Folds the lane of a layer, or unfolds it. */
  fold(layer: string): void {
    const folded = new Set(this.folded.value);
    if (!folded.delete(layer)) folded.add(layer);
    this.folded.value = folded;
  }

  /** Folds the lanes of all these layers; if all are folded, unfolds them. */
  foldAll(layers: readonly string[]): void {
    this.folded.value = new Set(layers.every((name) => this.folded.value.has(name)) ? [] : layers);
  }

  /** Shows the last two minutes. */
  recent(): void {
    this.isOwn = false;
    this.end.value = this.length.value = null;
  }

  all(): void {
    this.isOwn = true;
    this.end.value = this.length.value = null;
  }

  /** Shows `factor` times as much; the tick `at`, by default the shown one, stays where it is. */
  zoom(factor: number, at = this.playback.looking.value ?? this.stage.tick): void {
    this.show(zoomed(this.span, at, factor));
  }

  /** Moves by a share of what is shown: below 0 to the past. */
  pan(share: number): void {
    const { from, to } = this.span;
    const ticks = Math.round(share * (to - from));
    this.show({ from: from + ticks, to: to + ticks });
  }

  /** Shows a span; one that ends at the newest tick goes on with it. */
  show({ from, to }: Span): void {
    const { first, head } = this.stage;
    const length = Math.max(LEAST_TICKS, to - from);
    if (length >= head - first) return this.all();
    this.isOwn = true;
    this.length.value = length;
    this.end.value = to >= head ? null : Math.max(first + length, to);
    if (to >= head && this.stood !== null) this.stood = head;
  }

  /** Selects the ticks between two, or none if they are one. */
  select(one: number, other: number): void {
    const { first, head } = this.stage;
    const [from, to] = [Math.max(first, Math.min(one, other)), Math.min(head, Math.max(one, other))];
    this.selected.value = from < to ? { from, to } : null;
    this.begun = null;
    if (this.playback.loop.value) this.playback.loop.value = this.selected.value;
  }

  /** Makes the shown tick the begin or the end of the selected span. */
  mark(edge: "from" | "to"): void {
    const at = this.playback.looking.value ?? this.stage.tick;
    const { from, to } = this.selected.value ?? { from: this.span.from, to: this.stage.head };
    if (edge === "to") return this.select(Math.min(this.begun ?? from, at - 1), at);
    this.select(at, Math.max(at + 1, to));
    this.begun = at; // the newest tick begins a span that has no tick yet
  }

  /** Plays the selected span again and again, or no longer. */
  loop(): void {
    this.playback.repeat(this.playback.loop.value ? null : this.selected.value);
  }
}
