import { describe, expect, it } from "vitest";
import { EventLog, actionText } from "./eventLog";
import type { EventLine, LogLine } from "../net/protocol";
import { verdict as whole } from "../net/types/examples";

const verdict = (tick: number, event: string, layer = 0) =>
  whole({ tick, actor: 1, layer, event, from: "A", to: "B" });

describe("EventLog", () => {
  it("marks events but not the end of a motion", () => {
    const eventLog = new EventLog();
    eventLog.judge(verdict(5, "JUMP"));
    eventLog.judge(verdict(6, "END"));
    expect(eventLog.marksBetween(1, 0, 9).map((mark) => mark.name)).toEqual(["JUMP"]);
  });

  it("takes what came before from the log, inputs only", () => {
    const eventLog = new EventLog();
    const line = (tick: number, kind: EventLine["kind"]): EventLine => ({
      number: tick,
      tick,
      kind,
      actor: 1,
      event: "GO",
    });
    const edit: LogLine = { number: 1, tick: 1, kind: "edit", name: "m", role: "m@2", text: "" };
    eventLog.remember([edit, line(2, "press"), line(3, "release"), line(9, "press")], 5);
    expect(eventLog.marksBetween(1, 0, 99)).toEqual([
      { tick: 2, actor: 1, layer: 0, name: "GO", kind: "logged" },
    ]);
  });

  it("keeps the events of layers apart", () => {
    const eventLog = new EventLog();
    eventLog.judge(verdict(5, "WAVE", 1));
    expect([0, 1].map((layer) => eventLog.marksBetween(1, 0, 9, layer).length)).toEqual([0, 1]);
  });

  it("ends a blend where the next begins", () => {
    const eventLog = new EventLog();
    eventLog.judge(verdict(10, "END"), 30);
    eventLog.judge(verdict(20, "STOP"), 12);
    expect(eventLog.blendsBetween(1, 0, 0, 99).map(({ tick, end }) => [tick, end])).toEqual([
      [10, 20],
      [20, 32],
    ]);
  });

  it("finds a blend that began before", () => {
    const eventLog = new EventLog();
    eventLog.judge(verdict(10, "STOP"), 30);
    expect(eventLog.blendsBetween(1, 0, 25, 99)).toHaveLength(1);
  });
});

describe("actionText", () => {
  it("is as it is written", () =>
    expect(actionText({ name: "drop", arguments: ["coins", 3] })).toBe("drop(coins, 3)"));
});
