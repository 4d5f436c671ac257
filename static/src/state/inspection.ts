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
  /** The line of machine.yaml that shall be shown, or null. */
  readonly fileLine = signal<number | null>(null);
  /** The tick that is explained, or null. */
  readonly why = signal<number | null>(null);
  /** Emitted if a cell of the table shall be shown. */
  readonly cells = new Event<CellRequest>();

  /** Opens the machine's file at a line. */
  showFileLine(line: number): void {
    this.drawer.value = "text";
    this.fileLine.value = line;
  }

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
  const moved = movedState(operation);
  if (!moved || moved.layer !== layer) return selected;
  // A composite state takes its inner states along.
  const isIn = state === moved.old || state.startsWith(`${moved.old}.`);
  return isIn ? { ...selected, state: moved.now + state.slice(moved.old.length) } : selected;
}

/** Returns the full names of a state before and after an operation that gives it another one. */
function movedState(operation: Operation): { layer: string; old: string; now: string } | null {
  if (
    operation.kind !== "rename_state" &&
    operation.kind !== "nest_state" &&
    operation.kind !== "unnest_state"
  )
    return null;
  const { layer = "base", state: old } = operation;
  const [outer, own] = split(old);
  if (operation.kind === "rename_state") return { layer, old, now: joined(outer, operation.to) };
  if (operation.kind === "nest_state") return { layer, old, now: joined(operation.into, own) };
  return { layer, old, now: joined(split(outer)[0], own) };
}

/** Returns the composite state around a state, and the state's own name. */
function split(state: string): [string, string] {
  const dot = state.lastIndexOf(".");
  return dot < 0 ? ["", state] : [state.slice(0, dot), state.slice(dot + 1)];
}

const joined = (outer: string, own: string): string => (outer ? `${outer}.${own}` : own);
