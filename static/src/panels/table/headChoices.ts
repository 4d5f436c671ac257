/** What the menu of a head offers: the operations that change the structure of a table. */

import type { LayerInfo, Operation } from "../../net/protocol";
import type { App } from "../../view/app";
import { columns } from "./drawTable";

/** A row's head, a column's head, or the corner. */
export interface Head {
  kind: "state" | "event" | "corner";
  name: string;
}

/** A text that a choice asks for. */
export interface Ask {
  label: string;
  value: string;
  hint?: string;
  /** Texts that are proposed. */
  proposals?: readonly string[];
  operations: (text: string) => Operation[];
}

export interface Choice {
  words: string;
  off?: boolean;
  ask?: Ask;
  run?: (app: App) => void;
  operations?: readonly Operation[];
  /** The operations that are offered if these are refused. */
  anyway?: readonly Operation[];
}

const select = (layer: string, state: string, event: string | null) => (app: App) => {
  app.inspection.selected.value = { layer, state, event };
  app.inspection.drawer.value = "cell";
};

const newState = (layer: string, before: string | null): Ask => ({
  label: "new state",
  value: "",
  hint: "RUN",
  operations: (state) => [{ kind: "add_state", state, layer, ...(before !== null && { before }) }],
});

const newEvent = (layer: string, before: string | null): Ask => ({
  label: "new event",
  value: "",
  hint: "FASTER",
  operations: (event) => [{ kind: "add_event", event, layer, ...(before !== null && { before }) }],
});

/** Returns the choices for a head of a layer's table. */
export function choicesOf({ kind, name }: Head, layer: LayerInfo, events: readonly string[]): Choice[] {
  if (kind === "corner") return cornerChoices(layer.name);
  return kind === "state" ? stateChoices(name, layer) : eventChoices(name, layer, columns(layer, events));
}

function cornerChoices(layer: string): Choice[] {
  return [
    { words: "add a state …", ask: newState(layer, null) },
    { words: "add an event …", ask: newEvent(layer, null) },
    { words: "default of all cells …", run: select(layer, "*", "*") },
  ];
}

function stateChoices(state: string, { name: layer, states, composites, initial }: LayerInfo): Choice[] {
  const outer = states.find(({ name }) => name === state)?.outer ?? "";
  const row = states.filter((other) => other.outer === outer).map(({ name }) => name);
  const at = row.indexOf(state);
  const own = { state, layer };
  const move = (before: string | undefined): Operation[] => [
    { kind: "move_state", ...own, ...(before !== undefined && { before }) },
  ];
  const renamed: Ask = {
    label: "name",
    value: outer ? state.slice(outer.length + 1) : state,
    operations: (to) => [{ kind: "rename_state", ...own, to }],
  };
  return [
    ...(layer === "base" ? [{ words: "go there", run: (app: App) => void app.travel.go(state) }] : []),
    { words: "clip, blend, markers …", run: select(layer, state, null) },
    { words: "rename …", ask: renamed },
    { words: "add a state above …", ask: newState(layer, state) },
    { words: "move up", off: at === 0, operations: move(row[at - 1]) },
    { words: "move down", off: at === row.length - 1, operations: move(row[at + 2]) },
    { words: "put into a sub-machine …", ask: nesting(own, outer, composites) },
    ...(outer
      ? [{ words: `take out of ${outer}`, operations: [{ kind: "unnest_state" as const, ...own }] }]
      : []),
    {
      words: "make it the first state",
      off: state === (composites.find(({ name }) => name === outer)?.initial ?? initial),
      operations: [{ kind: "set_initial", ...own }],
    },
    { words: "default of this row …", run: select(layer, state, "*") },
    {
      words: "delete",
      operations: [{ kind: "delete_state", ...own }],
      anyway: [{ kind: "delete_state", ...own, also_cells: true }],
    },
  ];
}

/** Asks for a sub-machine of the state's own table: one that is there, or a new one. */
function nesting(
  own: { state: string; layer: string },
  outer: string,
  composites: LayerInfo["composites"],
): Ask {
  const start = outer ? `${outer}.` : "";
  const there = composites
    .filter((other) => other.outer === outer)
    .map(({ name }) => name.slice(start.length));
  return {
    label: "sub-machine",
    value: "",
    hint: there[0] ?? "FIGHT",
    proposals: there,
    operations: (name) => [{ kind: "nest_state", ...own, into: start + name }],
  };
}

function eventChoices(event: string, { name: layer }: LayerInfo, shown: readonly string[]): Choice[] {
  const at = shown.indexOf(event);
  const isEnd = event === "END";
  const move = (before: string | undefined): Operation[] => [
    { kind: "move_event", event, layer, ...(before !== undefined && { before }) },
  ];
  const buffer: Ask = {
    label: "waits, s",
    value: "",
    hint: "0.3",
    operations: (text) => [{ kind: "set_event", event, buffer: Number(text) }],
  };
  return [
    { words: "default of this column …", run: select(layer, "*", event) },
    { words: "rename …", off: isEnd, ask: { ...renaming(event) } },
    { words: "how long it waits …", off: isEnd, ask: buffer },
    { words: "add an event before …", ask: newEvent(layer, event) },
    { words: "move left", off: at <= 0, operations: move(shown[at - 1]) },
    { words: "move right", off: at === shown.length - 1, operations: move(shown[at + 2]) },
    {
      words: "delete",
      off: isEnd,
      operations: [{ kind: "delete_event", event }],
      anyway: [{ kind: "delete_event", event, also_cells: true }],
    },
  ];
}

const renaming = (event: string): Ask => ({
  label: "name",
  value: event,
  operations: (to) => [{ kind: "rename_event", event, to }],
});
