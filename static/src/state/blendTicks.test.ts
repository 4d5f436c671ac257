import { describe, expect, it } from "vitest";
import { blendTicks } from "./blendTicks";
import type { MachineInfo } from "../net/protocol";
import { verdict } from "../net/types/examples";

const fork = {
  to: "A",
  blend: 0.5,
  alternatives: [
    { to: "A", blend: 0.5 },
    { to: "B", blend: 0.1 },
  ],
};
const machine = {
  layers: [{ table: { WALK: { STOP: { to: "STAT", blend: 0.25, alternatives: [] }, JUMP: fork } } }],
} as unknown as MachineInfo;
const taken = verdict({ event: "STOP", to: "STAT" });

describe("blendTicks", () => {
  it("counts a cell's seconds in ticks", () => expect(blendTicks(machine, taken, 60)).toBe(15));

  it("takes the alternative that it went to", () =>
    expect(blendTicks(machine, { ...taken, event: "JUMP", to: "B" }, 60)).toBe(6));

  it.each([{ verdict: "dropped" as const }, { to: "" }, { layer: 7 }])("is none for %j", (other) => {
    expect(blendTicks(machine, { ...taken, ...other }, 60)).toBe(0);
  });
});
