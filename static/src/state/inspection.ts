/** What the page explains and points at: panels ask for it here, other panels show it. */

import { signal } from "@preact/signals-core";
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
  /** The tick that is explained, or null. */
  readonly why = signal<number | null>(null);
  /** Emitted if a cell of the table shall be shown. */
  readonly cells = new Event<CellRequest>();
}
