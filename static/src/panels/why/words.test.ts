import { describe, expect, it } from "vitest";
import type { Verdict } from "../../net/protocol";
import { blendWords, movedWords, outcomeWords, valueWords, verdictLine } from "./words";

describe("verdictLine", () => {
  const base: Verdict = { type: "verdict", tick: 1, actor: 0, layer: 0, event: "JUMP", verdict: "taken", reason: "cell", from: "WALK", to: "JUMP" };

  it("tells what was taken", () => expect(verdictLine(base)).toBe("JUMP: WALK → JUMP"));

  it("tells a stay", () => expect(verdictLine({ ...base, to: "" })).toBe("JUMP: stays in WALK"));

  it("tells why it was dropped", () => {
    expect(verdictLine({ ...base, verdict: "dropped", to: null, reason: "blank cell" })).toBe("JUMP: dropped in WALK, blank cell");
  });
});

describe("the why-panel", () => {
  it("gives values shortly", () => expect(valueWords({ stamina: 5, speed: 1.41999999 })).toEqual(["stamina 5", "speed 1.42"]));

  it("tells a stay from a way", () => expect(outcomeWords({ verdict: "taken", from_state: "WALK", to_state: "" })).toBe("stays in WALK"));

  it("tells motions that meet from those that blend", () => {
    expect([0, 0.25, null].map((seconds) => blendWords({ blend_seconds: seconds, curve: "cubic" }))).toEqual(["none: the motions meet", "0.25 s, cubic", ""]);
  });

  it("leaves out what a joint did not do", () => expect(movedWords({ degrees: 0, millimetres: 30.2 })).toBe("30 mm"));
});
