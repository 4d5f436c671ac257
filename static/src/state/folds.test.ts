// @vitest-environment happy-dom
import { signal } from "@preact/signals-core";
import { beforeEach, expect, test } from "vitest";
import type { LayerInfo, MachineInfo } from "../net/protocol";
import { Folds, around, standIns } from "./folds";
import type { WatchedMachine } from "./watchedMachine";

const named = (name: string, outer = "") => ({ name, outer });
const layer = {
  name: "base",
  states: [named("STAND"), named("FIGHT.HIT", "FIGHT"), named("FIGHT.DOWN.FALL", "FIGHT.DOWN")],
  composites: [named("FIGHT"), named("FIGHT.DOWN", "FIGHT")],
} as unknown as LayerInfo;

function folds(name = "knight"): Folds {
  const info = signal({ name } as MachineInfo);
  return new Folds({ info, layerInfo: layer } as unknown as WatchedMachine);
}

beforeEach(() => localStorage.clear());

test("sub-machines are around a state from inside out", () => {
  expect(around(layer, "FIGHT.DOWN.FALL")).toEqual(["FIGHT.DOWN", "FIGHT"]);
});

test("the outermost folded sub-machine stands for a state", () => {
  expect([...standIns(layer, new Set(["FIGHT", "FIGHT.DOWN"])).values()]).toEqual([
    "STAND",
    "FIGHT",
    "FIGHT",
  ]);
});

test("an inner sub-machine is folded alone", () => {
  expect([...standIns(layer, new Set(["FIGHT.DOWN"])).values()]).toEqual([
    "STAND",
    "FIGHT.HIT",
    "FIGHT.DOWN",
  ]);
});

test("all are folded at once, and unfolded", () => {
  const made = folds();
  made.toggleAll();
  expect(made.names.value.size).toBe(2);
  made.toggleAll();
  expect(made.names.value.size).toBe(0);
});

test("what hides a state is unfolded, from outside in", () => {
  const made = folds();
  made.toggleAll();
  made.reveal("FIGHT.DOWN.FALL");
  expect(made.shown.value.get("FIGHT.DOWN.FALL")).toBe("FIGHT.DOWN.FALL");
});

test("this browser keeps what is folded, for each machine", () => {
  folds().fold(["FIGHT"], true);
  expect(folds().names.value).toEqual(new Set(["FIGHT"]));
  expect(folds("troll").names.value.size).toBe(0);
});
