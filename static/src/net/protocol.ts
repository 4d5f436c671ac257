/** What the server says: the JSON of the socket (`statwalk.v1`) and of the REST interface under /api. */

export type { Cell, Edge, Edited, Edition, Finding, KeyBinding, LayerInfo, MachineInfo, Parameter, StateInfo } from "./machineinfo";
export type { Explained, Plan, Remedy, Why, WhyNot } from "./explained";

export const SUBPROTOCOL = "statwalk.v1";

export type FrameKind = "pose" | "glb";
export type EventKind = "press" | "hold" | "release";

export interface ActorName {
  id: number;
  name: string;
}

/** Actors that share a character and a machine; `nodes[j]` is the node of model.glb that joint j moves. */
export interface CastHello {
  role: string;
  character: string;
  model: string;
  machine: string;
  joints: number;
  weights: number;
  names: string[];
  nodes: number[];
  parents: number[];
  /** Which version of the machine the stage plays. */
  version: number;
  layers: string[];
  /** The states of all layers; `state_layers` says whose each is. */
  states: string[];
  state_layers: number[];
  events: string[];
  actors: ActorName[];
}

export interface Hello {
  type: "hello";
  version: string;
  stage: string;
  epoch: number;
  rate: number;
  tick: number;
  head: number;
  first: number;
  frames: FrameKind;
  paused: boolean;
  speed: number;
  clock: "real" | "manual";
  casts: CastHello[];
}

export interface Status {
  type: "status";
  tick: number;
  head: number;
  first: number;
  paused: boolean;
  speed: number;
  viewers: number;
}

export interface Verdict {
  type: "verdict";
  tick: number;
  actor: number;
  layer: number;
  event: string;
  verdict: "taken" | "waits" | "dropped";
  reason: string;
  from: string | null;
  /** The state it led to; null or empty where the state stayed. */
  to: string | null;
  /** Row and column of the cell that decided, as they are written. */
  cell?: [string, string] | null;
  /** What the cell's condition saw. */
  values?: Record<string, number>;
}

export interface Action {
  type: "action";
  seq: number;
  tick: number;
  actor: number;
  name: string;
  arguments: (string | number)[];
}

export interface Accepted {
  type: "accepted";
  ref: unknown;
  tick: number;
  stage: string;
}

export interface Refused {
  type: "error";
  ref?: unknown;
  title?: string;
  detail?: string;
}

export interface Forked {
  type: "forked";
  stage: string;
}

export interface Pong {
  type: "pong";
  ref: unknown;
}

export type ServerMessage = Hello | Status | Verdict | Action | Accepted | Refused | Forked | Pong;

export type ClientMessage =
  | { type: "ack"; tick: number }
  | { type: "event"; kind: EventKind; actor: number; event: string; ref: string; tick?: number }
  | { type: "set"; actor: number; parameter: string; value: number }
  | { type: "look"; tick: number }
  | { type: "live" }
  | { type: "frames"; frames: FrameKind }
  | { type: "ping"; ref: number };

export interface MachineSummary {
  name: string;
  title?: string | null;
  character: string;
  /** The scene that it belongs to, or empty. */
  scene: string;
}

export interface CharacterSummary {
  name: string;
  /** A machine that it plays in, if there is one. */
  machine: string | null;
  uploaded: boolean;
}

export interface UploadedCharacter {
  name: string;
  joints: number;
  clips: number;
  vertices: number;
  notes: string[];
}

/** What the clips of a character propose to be; `meanings` explains the states that have one. */
export interface Mapping {
  character: string;
  mapping: Record<string, string>;
  meanings: Record<string, string>;
}

export interface StageInfo {
  id: string;
  actors: { id: number; name: string; machine: string; state: string }[];
}

export interface LogEntry {
  tick: number;
  kind: string;
  actor: number;
  name?: string;
}

/** From `tick` on the actor is in `state`. */
export interface StateChange {
  tick: number;
  actor: number;
  layer: number;
  state: string;
}

export interface StateHistory {
  head: number;
  changes: StateChange[];
}

/** The message in `text`, or null where it is none of ours. */
export function parseMessage(text: string): ServerMessage | null {
  try {
    const value: unknown = JSON.parse(text);
    const known = typeof value === "object" && value !== null && typeof (value as { type?: unknown }).type === "string";
    return known ? (value as ServerMessage) : null;
  } catch {
    return null;
  }
}

export interface SceneSummary {
  name: string;
  title: string;
  description: string;
  actors: number;
}
