/** Whole values of the server's types, for tests: a test names the members that it is about. */

import type { Alternative, Cell, Finding, KeyBinding, StateInfo } from "./machine";
import type { Verdict } from "./messages";

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
    loop: false,
    duration: 0,
    outer: "",
    final: false,
    markers: [],
    expressions: [],
    ...members,
  };
}

export function finding(members: Partial<Finding>): Finding {
  return {
    kind: "k",
    severity: "info",
    message: "m",
    line: 0,
    state: null,
    event: null,
    layer: "",
    replay: [],
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
