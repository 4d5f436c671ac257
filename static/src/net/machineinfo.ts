/** What the server says of a machine: its tables, layer by layer, what it was found to be, and its versions. */

/** One of several outcomes of a cell. */
export interface Outcome {
  to: string;
  condition: string;
  weight: number | null;
  blend: number;
  restart: boolean;
  action: string | null;
}

/** One filled cell of the expanded table; `source` says whether it was written or came from a default. */
export interface Cell {
  to: string | null;
  when?: string;
  /** Seconds. */
  blend?: number;
  curve?: string;
  /** Where the motion is entered, 0…1 of it, or "match". */
  enter?: number | string;
  restart?: boolean;
  action?: string | null;
  source?: string;
  line?: number;
  /** Row and column as they stand in the file. */
  written?: [string, string];
  alternatives?: Outcome[];
}

export interface KeyBinding {
  press?: string | null;
  hold?: string | boolean | null;
  release?: string | null;
}

export interface Edge {
  from: string;
  to: string;
  events: string[];
}

export interface StateInfo {
  name: string;
  /** Null where the layer does nothing. */
  motion: string | null;
  loop: boolean;
  /** Seconds. */
  duration: number;
  /** The state whose machine this is a state of, or empty. */
  outer?: string;
  markers?: { name: string; phase: number }[];
}

/** A table of its own for some of the joints. */
export interface LayerInfo {
  name: string;
  mode: string;
  mask: string[];
  weight: number | string;
  initial: string;
  states: StateInfo[];
  table: Record<string, Record<string, Cell | null>>;
  /** The table as it is written: first the head, then a line for each state. */
  rows: string[][];
  edges: Edge[];
}

export interface Parameter {
  name: string;
  default: number;
  minimum: number;
  maximum: number;
  smooth: number;
  /** A flock sets it, whatever comes from outside. */
  driven: boolean;
}

/** The members beside `layers` are those of the base. */
export interface MachineInfo {
  name: string;
  title?: string | null;
  description?: string | null;
  character: string;
  /** Counts the edits, from 1. */
  version: number;
  /** Where an edit is kept: in machine.yaml, or until the server stops. */
  saved: "file" | "memory";
  initial: string;
  idle?: string | null;
  states: StateInfo[];
  events: string[];
  table: Record<string, Record<string, Cell | null>>;
  keys: Record<string, KeyBinding>;
  edges: Edge[];
  layers: LayerInfo[];
  parameters: Parameter[];
}

/** One thing that the verifier found; `line` is 0 where there is none to name. */
export interface Finding {
  kind: string;
  severity: "error" | "warning" | "info";
  message: string;
  line: number;
  state?: string | null;
  event?: string | null;
  layer?: string;
}

/** The answer to an edit, or to a trial of one. */
export type Edited = MachineInfo & { findings: Finding[] };

export interface Edition {
  version: number;
  /** Seconds since 1970. */
  at: number;
  what: string;
  /** Where an undo leads; 0: nowhere. */
  before: number;
}
