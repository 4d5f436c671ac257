import { describe, expect, it } from "vitest";
import type { Plan } from "../net/protocol";
import { stepAt } from "./travel";

const plan: Plan = {
  goal: "FLY",
  stage: "main",
  tick: 1,
  seconds: 2,
  steps: ["STAT", "WALK", "STAT", "JUMP"].map((state) => ({ state, event: "E", seconds: 1 })),
};

describe("stepAt", () => {
  it("goes on with the character", () => expect(stepAt(plan, "WALK", 0)).toBe(1));

  it("never goes back", () => expect(stepAt(plan, "STAT", 1)).toBe(2));

  it("stays where the character is off the way", () => expect(stepAt(plan, "FALL", 2)).toBe(2));
});
