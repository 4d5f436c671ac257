/** What the page explains and points at: panels ask for it here, other panels show it. */

import { signal } from "@preact/signals-core";
import type { Operation } from "../net/protocol";
import { Event } from "./event";

export interface CellRequest {
  layer: number;
  state: string;
  event: string;
  /** A text to type into the cell, which you keep or drop; null: only show the cell. */
  text: string | null;
}

/** A state that you have chosen, or one of its cells: the arrow of an event. */
export interface Selected {
  layer: string;
  state: string;
  event: string | null;
}

/** What the drawer beside the panels shows; null: it is closed. */
export type Drawer = "cell" | "machine" | "versions" | "text" | "stages" | "people" | null;

export class Inspection {
  readonly selected = signal<Selected | null>(null);
  readonly drawer = signal<Drawer>(null);
  /** Whether light and background are chosen. */
  readonly isSceneShown = signal(false);
  /** The tick that is explained, or null. */
  readonly why = signal<number | null>(null);
  /** Emitted if a cell of the table shall be shown. */
  readonly cells = new Event<CellRequest>();

  /** Keeps the selected state or cell selected under its new name. */
  follow(operations: readonly Operation[]): void {
    const before = this.selected.value;
    if (before) this.selected.value = operations.reduce(renamed, before);
  }
}

function renamed(selected: Selected, operation: Operation): Selected {
  const { layer, state, event } = selected;
  if (operation.kind === "rename_layer" && operation.layer === layer)
    return { ...selected, layer: operation.to };
  if (operation.kind === "rename_event" && operation.event === event)
    return { ...selected, event: operation.to };
  if (operation.kind !== "rename_state" || (operation.layer ?? "base") !== layer) return selected;
  const { state: old, to } = operation;
  const whole = old.slice(0, old.lastIndexOf(".") + 1) + to;
  // A composite state takes its inner states along.
  const isIn = state === old || state.startsWith(`${old}.`);
  return isIn ? { ...selected, state: whole + state.slice(old.length) } : selected;
}
