/** Keeps the verdicts, blends and actions that this page has heard of. */

import type { Action, EventLine, LogLine, Verdict } from "../net/protocol";
import { lowerBound } from "./sorted";

export interface EventMark {
  tick: number;
  actor: number;
  layer: number;
  name: string;
  /** The verdict, or `logged` for an event from before this page was opened. */
  kind: Verdict["verdict"] | "logged";
}

/** A blend between two motions, from tick `tick` to tick `end`. */
export interface BlendSpan {
  tick: number;
  actor: number;
  layer: number;
  end: number;
}

export interface ActionMark {
  tick: number;
  actor: number;
  name: string;
}

const MOST = 20_000;
/** No blend is longer than a minute, at any tick rate. */
const LONGEST_BLEND_TICKS = 15_000;

function keep<T>(list: T[], item: T): void {
  list.push(item);
  if (list.length > MOST) list.splice(0, MOST / 4);
}

function within<T extends { tick: number; actor: number }>(
  list: readonly T[],
  actor: number,
  from: number,
  to: number,
): T[] {
  const found: T[] = [];
  for (let i = lowerBound(list, from, (item) => item.tick); i < list.length && list[i]!.tick <= to; i++) {
    if (list[i]!.actor === actor) found.push(list[i]!);
  }
  return found;
}

/** Writes an action as in the table: `drop(coins, 3)`. */
export function actionText({ name, arguments: values }: Pick<Action, "name" | "arguments">): string {
  return values.length ? `${name}(${values.join(", ")})` : name;
}

export class EventLog {
  private marks: EventMark[] = [];
  private logged: EventMark[] = [];
  private spans: BlendSpan[] = [];
  private done: ActionMark[] = [];

  clear(): void {
    this.marks = [];
    this.logged = [];
    this.spans = [];
    this.done = [];
  }

  /** Adds a verdict: a mark for an event (END gets none), a span for a blend of `blend` ticks, if not 0. */
  judge({ tick, actor, layer, event, verdict }: Verdict, blend = 0): void {
    if (blend > 0) keep(this.spans, { tick, actor, layer, end: tick + blend });
    if (event !== "END") keep(this.marks, { tick, actor, layer, name: event, kind: verdict });
  }

  act(action: Action): void {
    keep(this.done, { tick: action.tick, actor: action.actor, name: actionText(action) });
  }

  /**
   * Takes the events of the stage's log up to tick `before`; from there on this page has verdicts of its own.
   */
  remember(lines: readonly LogLine[], before: number): void {
    const inputs = lines.filter(
      (line): line is EventLine => (line.kind === "press" || line.kind === "hold") && line.tick <= before,
    );
    this.logged = inputs.map(({ tick, actor, event }) => ({
      tick,
      actor,
      layer: 0,
      name: event,
      kind: "logged",
    }));
  }

  /** Returns the events of `actor` in the ticks `from`…`to`, of all layers or of one. */
  marksBetween(actor: number, from: number, to: number, layer: number | null = null): EventMark[] {
    const found = [...within(this.logged, actor, from, to), ...within(this.marks, actor, from, to)];
    return layer === null ? found : found.filter((mark) => mark.layer === layer);
  }

  /**
   * Returns the blends of a layer of `actor` that overlap the ticks `from`…`to`; each ends where the next
   * begins.
   */
  blendsBetween(actor: number, layer: number, from: number, to: number): BlendSpan[] {
    const spans = within(this.spans, actor, from - LONGEST_BLEND_TICKS, to).filter(
      (span) => span.layer === layer,
    );
    return spans
      .map((span, i) => ({ ...span, end: Math.min(span.end, spans[i + 1]?.tick ?? Infinity) }))
      .filter((span) => span.end >= from);
  }

  actionsBetween(actor: number, from: number, to: number): ActionMark[] {
    return within(this.done, actor, from, to);
  }
}
