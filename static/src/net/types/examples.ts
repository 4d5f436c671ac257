/** Whole values of the server's types, for tests: a test names the members that it is about. */

import type {
  Alternative,
  Cell,
  Finding,
  KeyBinding,
  LayerInfo,
  MachineInfo,
  Parameter,
  StateInfo,
} from "./machine";
import type { CastHello, Hello, Verdict } from "./messages";
import type { StageInfo } from "./rest";

export function cell(members: Partial<Cell>): Cell {
  const plain = {
    to: null,
    when: "now",
    blend: 0,
    curve: "quintic" as const,
    enter: 0,
    restart: false,
    action: null,
    source: "cell",
    line: 0,
  };
  return { ...plain, written: ["", ""], alternatives: [], ...members };
}

export function alternative(members: Partial<Alternative>): Alternative {
  return {
    to: "",
    condition: "",
    weight: null,
    blend: 0.25,
    curve: "quintic",
    enter: 0,
    restart: false,
    action: null,
    ...members,
  };
}

export function state(members: Partial<StateInfo>): StateInfo {
  return {
    name: "",
    motion: null,
    over: [],
    clips: [],
    points: {},
    clip_markers: {},
    speed: 1,
    ground_speed: null,
    loop: false,
    duration: 0,
    outer: "",
    final: false,
    framing: null,
    markers: [],
    expressions: [],
    ...members,
  };
}

export function layer(members: Partial<LayerInfo>): LayerInfo {
  const kind = { name: "base", mode: "override" as const, mask: [], weight: 1, initial: "" };
  return { ...kind, states: [], composites: [], table: {}, rows: [], edges: [], ...members };
}

export function finding(members: Partial<Finding>): Finding {
  return {
    kind: "k",
    severity: "info",
    message: "m",
    subject: members.message ?? "m",
    line: 0,
    state: null,
    event: null,
    layer: "",
    replay: [],
    ticks: 0,
    ...members,
  };
}

export function keyBinding(members: Partial<KeyBinding>): KeyBinding {
  return { press: null, release: null, hold: false, change: {}, ...members };
}

export function verdict(members: Partial<Verdict>): Verdict {
  const place = { tick: 1, actor: 0, layer: 0, event: "JUMP", from: "WALK", to: "JUMP", other: -1 };
  return {
    type: "verdict",
    ...place,
    verdict: "taken",
    reason: "cell",
    cell: null,
    source: "",
    line: 0,
    values: {},
    ...members,
  };
}

export function parameter(members: Partial<Parameter>): Parameter {
  const range = { default: 0, minimum: 0, maximum: 1 };
  const kind = { kind: "number" as const, vector: "", joint: "", freedom: "", event: "", driven: false };
  return { name: "", smooth: 0, ...range, ...kind, ...members };
}

export function machine(members: Partial<MachineInfo>): MachineInfo {
  const facts = { name: "m", title: "M", description: "", character: "c", scene: "" };
  const version = { version: 1, saved: "memory" as const, undo: 0, redo: 0 };
  const states = {
    initial: "",
    idle: null,
    fallback: "",
    foot_lock: 0,
    properties: [],
    states: [],
    table: {},
    rows: [],
    edges: [],
    layers: [],
  };
  const defaults = { when: "now", blend: 0.2, curve: "cubic" as const, buffer: 0.3 };
  const inputs = { events: [], keys: {}, parameters: [], variables: [], senses: {} };
  const world = { colliders: {}, ground: [], limits: [], solvers: [], chains: [] };
  const texts = { expressions: [], expression_text: "", text: "", tables: {}, view: {} };
  return { ...facts, ...version, defaults, ...states, ...inputs, ...world, ...texts, ...members };
}

export function cast(members: Partial<CastHello>): CastHello {
  const model = { role: "", character: "c", model: "", machine: "m", version: 1, joints: 0, weights: 0 };
  const joints = { names: [], nodes: [], parents: [], muscle_bones: [], colliders: [] };
  const states = { layers: ["base"], states: [], state_layers: [], events: [] };
  return { ...model, ...joints, ...states, actors: [], skinning: "linear", ...members };
}

export function hello(members: Partial<Hello>): Hello {
  const stream = { epoch: 1, rate: 60, clock: "real" as const, frames: "pose" as const, skinning: null };
  const ticks = { tick: 0, head: 0, first: 0, restored: null };
  const status = { paused: false, speed: 1, viewers: 1, pace: 1, trouble: "", changed: null };
  return {
    ...{ type: "hello", version: "0", stage: "main", viewer: 1 },
    ...stream,
    ...ticks,
    ...status,
    casts: [],
    ...members,
  };
}

export function stageInfo(members: Partial<StageInfo>): StageInfo {
  const known = { name: "", scene: null, machines: [], made: null, origin: null, unclaimed: false };
  const ticks = { tick: 0, head: 0, first: 0, seconds: 0, restored: null, hash: "" };
  const clock = {
    clock: "real" as const,
    rate: 60,
    paused: false,
    speed: 1,
    pace: 1,
    asleep: false,
    full: false,
    changed: null,
  };
  return {
    ...{ id: "main", inputs: 0, newest_input: null, seed: 1, viewers: 1, trouble: "", actors: [] },
    ...known,
    ...ticks,
    ...clock,
    ...members,
  };
}
