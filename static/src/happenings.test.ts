import { describe, expect, it } from "vitest";
import { Happenings, actionText } from "./happenings";
import type { Verdict } from "./net/protocol";

const verdict = (tick: number, event: string, layer = 0): Verdict => ({
  type: "verdict", tick, actor: 1, layer, event, verdict: "taken", reason: "", from: "A", to: "B",
});

describe("Happenings", () => {
  it("marks events but not the end of a motion", () => {
    const happenings = new Happenings();
    happenings.judge(verdict(5, "JUMP"));
    happenings.judge(verdict(6, "END"));
    expect(happenings.marksBetween(1, 0, 9).map((mark) => mark.name)).toEqual(["JUMP"]);
  });

  it("takes what came before from the log, inputs only", () => {
    const happenings = new Happenings();
    const entry = (tick: number, kind: string) => ({ tick, kind, actor: 1, name: "GO" });
    happenings.remember([entry(1, "add"), entry(2, "press"), entry(3, "release"), entry(9, "press")], 5);
    expect(happenings.marksBetween(1, 0, 99)).toEqual([{ tick: 2, actor: 1, layer: 0, name: "GO", kind: "logged" }]);
  });

  it("keeps the events of layers apart", () => {
    const happenings = new Happenings();
    happenings.judge(verdict(5, "WAVE", 1));
    expect([0, 1].map((layer) => happenings.marksBetween(1, 0, 9, layer).length)).toEqual([0, 1]);
  });

  it("ends a blend where the next begins", () => {
    const happenings = new Happenings();
    happenings.judge(verdict(10, "END"), 30);
    happenings.judge(verdict(20, "STOP"), 12);
    expect(happenings.blendsBetween(1, 0, 0, 99).map(({ tick, end }) => [tick, end])).toEqual([[10, 20], [20, 32]]);
  });

  it("finds a blend that began before", () => {
    const happenings = new Happenings();
    happenings.judge(verdict(10, "STOP"), 30);
    expect(happenings.blendsBetween(1, 0, 25, 99)).toHaveLength(1);
  });
});

describe("actionText", () => {
  it("is as it is written", () => expect(actionText({ name: "drop", arguments: ["coins", 3] })).toBe("drop(coins, 3)"));
});
