import { expect, test } from "vitest";
import type { LayerInfo } from "../../net/protocol";
import { choicesOf } from "./headChoices";

const state = (name: string, outer = "") => ({ name, outer });
const layer = {
  name: "base",
  initial: "A",
  composites: [
    { name: "IN", initial: "IN.X", outer: "" },
    { name: "IN.DEEP", initial: "IN.DEEP.Z", outer: "IN" },
  ],
  states: [state("A"), state("IN.X", "IN"), state("IN.Y", "IN"), state("B")],
  rows: [["state", "GO", "STOP", "END"]],
  table: {},
} as unknown as LayerInfo;
const events = ["GO", "STOP", "END"];

const operations = (kind: "state" | "event", name: string, words: string) =>
  choicesOf({ kind, name }, layer, events).find((choice) => choice.words === words)!;

test("a state moves among the states of its own machine", () => {
  expect(operations("state", "A", "move down").operations).toEqual([
    { kind: "move_state", state: "A", layer: "base" },
  ]);
  expect(operations("state", "IN.Y", "move up").operations).toEqual([
    { kind: "move_state", state: "IN.Y", layer: "base", before: "IN.X" },
  ]);
  expect(operations("state", "IN.X", "move up").off).toBe(true);
});

test("a state of a sub-machine is renamed by its short name", () => {
  const { ask } = operations("state", "IN.X", "rename …");
  expect(ask!.value).toBe("X");
  expect(ask!.operations("Z")).toEqual([{ kind: "rename_state", state: "IN.X", layer: "base", to: "Z" }]);
});

test("a state goes into a sub-machine of its own table, there or new, and out again", () => {
  const { ask } = operations("state", "IN.X", "put into a sub-machine …");
  expect(ask!.proposals).toEqual(["DEEP"]);
  expect(ask!.operations("NEW")).toEqual([
    { kind: "nest_state", state: "IN.X", layer: "base", into: "IN.NEW" },
  ]);
  expect(operations("state", "IN.X", "take out of IN").operations).toEqual([
    { kind: "unnest_state", state: "IN.X", layer: "base" },
  ]);
  expect(operations("state", "A", "put into a sub-machine …").ask!.proposals).toEqual(["IN"]);
  expect(
    choicesOf({ kind: "state", name: "A" }, layer, events).some(({ words }) => words.includes("out of")),
  ).toBe(false);
});

test("the first state of a sub-machine cannot be made its first", () =>
  expect(["IN.X", "IN.Y"].map((name) => operations("state", name, "make it the first state").off)).toEqual([
    true,
    false,
  ]));

test("END is no event that can be renamed or deleted", () => {
  expect(["rename …", "delete"].map((words) => operations("event", "END", words).off)).toEqual([true, true]);
});

test("a column moves to the right over the next one", () => {
  expect(operations("event", "GO", "move right").operations).toEqual([
    { kind: "move_event", event: "GO", layer: "base", before: "END" },
  ]);
});
