import { expect, it } from "vitest";
import type { Operation } from "../net/protocol";
import { Inspection, type Selected } from "./inspection";

const AT: Selected = { layer: "base", state: "FIGHT.GUARD", event: "JUMP" };
const renames = (state: string, to: string, layer?: string): Operation => ({
  kind: "rename_state",
  state,
  to,
  ...(layer !== undefined && { layer }),
});

const nests = (state: string, into: string): Operation => ({ kind: "nest_state", state, into });

it.each<[string, Operation, Selected]>([
  ["its state", renames("FIGHT.GUARD", "BLOCK"), { ...AT, state: "FIGHT.BLOCK" }],
  ["the state around it", renames("FIGHT", "BRAWL"), { ...AT, state: "BRAWL.GUARD" }],
  ["its state in a sub-machine", nests("FIGHT.GUARD", "FIGHT.HIGH"), { ...AT, state: "FIGHT.HIGH.GUARD" }],
  ["the state around it in a sub-machine", nests("FIGHT", "DAY"), { ...AT, state: "DAY.FIGHT.GUARD" }],
  ["its state outside", { kind: "unnest_state", state: "FIGHT.GUARD" }, { ...AT, state: "GUARD" }],
  ["its event", { kind: "rename_event", event: "JUMP", to: "LEAP" }, { ...AT, event: "LEAP" }],
  ["its layer", { kind: "rename_layer", layer: "base", to: "legs" }, { ...AT, layer: "legs" }],
  ["another state", renames("FIGHT.GUARDS", "BLOCK"), AT],
  ["a state of another layer", renames("FIGHT.GUARD", "BLOCK", "arms"), AT],
])("what is selected follows the new name of %s", (_, operation, expected) => {
  const inspection = new Inspection();
  inspection.selected.value = AT;
  inspection.follow([operation]);
  expect(inspection.selected.value).toEqual(expected);
});
