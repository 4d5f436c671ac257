/** What the server says of a tick of the past: why, why not, and the way to a state. */

/** A joint, and how much the transition has to move it. */
export interface Moved {
  joint: string;
  degrees: number;
  millimetres: number;
}

/** What became of one event. */
export interface Explained {
  event: string;
  layer: number;
  verdict: "taken" | "waits" | "dropped";
  reason: string;
  cell: [string, string] | null;
  source: string;
  line: number;
  values: Record<string, number>;
  other: number;
  from_state: string;
  to_state: string;
  blend_seconds: number | null;
  curve: string;
  joints: Moved[];
}

/** `states`, `since`: of each layer, and the tick in which it was entered. */
export interface Why {
  tick: number;
  actor: number;
  states: string[];
  since: number[];
  events: Explained[];
}

interface Change {
  kind: string;
  layer?: number;
  state?: string;
  event?: string;
  text?: string;
  parameter?: string;
  value?: number;
  tick?: number;
}

/** One change that makes the event fire; it has been tried. */
export interface Remedy {
  kind: string;
  text: string;
  change: Change;
  fires: number;
}

export interface WhyNot {
  fired: boolean;
  reason: string;
  remedies: Remedy[];
}

export interface Plan {
  goal: string;
  tick: number;
  seconds: number;
  steps: { state: string; event: string; seconds: number }[];
}
