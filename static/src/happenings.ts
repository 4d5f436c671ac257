/** What happened on the stage, as far as this page knows: events and their verdicts, blends, actions. */

import type { Action, LogEntry, Verdict } from "./net/protocol";
import { lowerBound } from "./sorted";

export interface EventMark {
  tick: number;
  actor: number;
  layer: number;
  name: string;
  /** A verdict's word, or `logged` for what came in before this page was there. */
  kind: "taken" | "waits" | "dropped" | "logged";
}

/** A motion goes over into the next from tick `tick` to tick `end`. */
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
/** A blend lasts a minute at most, at any rate a stage has. */
const LONGEST_BLEND_TICKS = 15_000;

function keep<T>(list: T[], one: T): void {
  list.push(one);
  if (list.length > MOST) list.splice(0, MOST / 4);
}

function within<T extends { tick: number; actor: number }>(list: readonly T[], actor: number, from: number, to: number): T[] {
  const found: T[] = [];
  for (let i = lowerBound(list, from, (one) => one.tick); i < list.length && list[i]!.tick <= to; i++) {
    if (list[i]!.actor === actor) found.push(list[i]!);
  }
  return found;
}

/** An action as its author writes it: `drop(coins, 3)`. */
export function actionText({ name, arguments: given }: Pick<Action, "name" | "arguments">): string {
  return given?.length ? `${name}(${given.join(", ")})` : name;
}

export class Happenings {
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

  /** A verdict on an event from outside becomes a mark; END is the motion's own and is none. `blend`: ticks of the blend that began, or 0. */
  judge({ tick, actor, layer, event, verdict }: Verdict, blend = 0): void {
    if (blend > 0) keep(this.spans, { tick, actor, layer, end: tick + blend });
    if (event !== "END") keep(this.marks, { tick, actor, layer, name: event, kind: verdict });
  }

  act(action: Action): void {
    keep(this.done, { tick: action.tick, actor: action.actor, name: actionText(action) });
  }

  /** The stage's log up to `before`, from where this page's own verdicts go on. */
  remember(entries: readonly LogEntry[], before: number): void {
    const inputs = entries.filter((entry) => (entry.kind === "press" || entry.kind === "hold") && entry.tick <= before);
    this.logged = inputs.map(({ tick, actor, name }) => ({ tick, actor, layer: 0, name: name ?? "", kind: "logged" }));
  }

  /** Events of `actor` in the ticks `from`…`to`; those of one layer, if it is named. */
  marksBetween(actor: number, from: number, to: number, layer: number | null = null): EventMark[] {
    const found = [...within(this.logged, actor, from, to), ...within(this.marks, actor, from, to)];
    return layer === null ? found : found.filter((mark) => mark.layer === layer);
  }

  /** Blends of a layer of `actor` that touch the ticks `from`…`to`; each ends where the next begins. */
  blendsBetween(actor: number, layer: number, from: number, to: number): BlendSpan[] {
    const own = within(this.spans, actor, from - LONGEST_BLEND_TICKS, to).filter((span) => span.layer === layer);
    return own.map((span, i) => ({ ...span, end: Math.min(span.end, own[i + 1]?.tick ?? Infinity) })).filter((span) => span.end >= from);
  }

  actionsBetween(actor: number, from: number, to: number): ActionMark[] {
    return within(this.done, actor, from, to);
  }
}
