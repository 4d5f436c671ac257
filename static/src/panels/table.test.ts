import { describe, expect, it } from "vitest";
import type { Verdict } from "../net/protocol";
import { cellSentence, cellText, verdictLine } from "./table";

describe("cellText", () => {
  it.each([
    [null, "", ""],
    [{ to: null }, "–", ""],
    [{ to: "WALK", when: "now" }, "WALK", ""],
    [{ to: "TLFT", when: "end", restart: true }, "TLFT!", "⇥"],
    [{ to: "JUMP", when: "marker left-down" }, "JUMP", "⇥ left-down"],
  ])("%j", (cell, to, how) => expect(cellText(cell)).toEqual({ to, how }));
});

describe("cellSentence", () => {
  it("says where a default comes from", () => {
    expect(cellSentence("WALK", "HIT", { to: "FALL", when: "now", blend: 0.1, source: "column default" })).toBe(
      "WALK, HIT → FALL: at once, blend 0.10 s, from column default",
    );
  });
});

describe("verdictLine", () => {
  const base: Verdict = { type: "verdict", tick: 1, actor: 0, layer: 0, event: "JUMP", verdict: "taken", reason: "cell", from: "WALK", to: "JUMP" };

  it("tells what was taken", () => expect(verdictLine(base)).toBe("JUMP: WALK → JUMP"));

  it("tells a stay", () => expect(verdictLine({ ...base, to: "" })).toBe("JUMP: stays in WALK"));

  it("tells why it was dropped", () => {
    expect(verdictLine({ ...base, verdict: "dropped", to: null, reason: "blank cell" })).toBe("JUMP: dropped in WALK, blank cell");
  });
});
