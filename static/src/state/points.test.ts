import { describe, expect, it } from "vitest";
import type { MachineInfo } from "../net/protocol";
import { aimsOf, reachedIn } from "./points";

const part = (name: string, kind: string, vector: string, standard: number): object => ({
  ...{ name, kind, vector, default: standard, minimum: -9, maximum: 9, smooth: 0, driven: false },
});

describe("the points and directions of a machine", () => {
  it("are put together from their components, in the space of the solver that reads them", () => {
    const parameters = [
      part("pace", "number", "", 1),
      part("grip.x", "point", "grip", 1),
      part("grip.y", "point", "grip", 2),
      part("grip.z", "point", "grip", 3),
      part("side.x", "direction", "side", 1),
    ];
    const solvers = [
      { target: "other", pole: null, space: "stage", start: "Hip", end: "Foot" },
      { target: "grip", pole: "side", space: "model", start: "Arm", end: "Hand" },
    ];
    expect(Object.fromEntries(aimsOf({ parameters, solvers } as unknown as MachineInfo))).toEqual({
      grip: { kind: "point", start: [1, 2, 3], isModel: true, joint: "Hand" },
      side: { kind: "direction", start: [1, 0, 0], isModel: true, joint: "Arm" },
    });
    expect(aimsOf(null).size).toBe(0);
  });
});

describe("the points that a state reaches for", () => {
  const states = [
    { name: "STAY", outer: "" },
    { name: "FIGHT.HIT", outer: "FIGHT" },
  ];
  const solvers = [
    { name: "one", solver: "force", target: "grip", weight: { FIGHT: "pull", STAY: 0 } },
    { name: "two", solver: "ccd", target: "gaze", weight: "look" },
  ];
  const machine = { states, solvers } as unknown as MachineInfo;

  it.each([
    ["STAY", []],
    ["FIGHT.HIT", ["grip"]],
    ["", []],
  ])("%s: %j", (state, points) => expect([...reachedIn(machine, state)]).toEqual(points));
});
