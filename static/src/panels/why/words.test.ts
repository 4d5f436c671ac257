import { describe, expect, it } from "vitest";
import { blendWords, movedWords, reasonWords, resultWords, valueWords } from "./words";

describe("the why-panel", () => {
  it("gives values shortly", () =>
    expect(valueWords({ stamina: 5, speed: 1.41999999 })).toEqual(["stamina 5", "speed 1.42"]));

  it("tells a stay from a way", () =>
    expect(resultWords({ verdict: "taken", from_state: "WALK", to_state: "" })).toBe("stays in WALK"));

  it("tells motions that meet from those that blend", () => {
    expect([0, 0.25, null].map((seconds) => blendWords({ blend_seconds: seconds, curve: "cubic" }))).toEqual([
      "none: the motions meet",
      "0.25 s, cubic",
      "",
    ]);
  });

  it("leaves out what a joint did not do", () =>
    expect(movedWords({ degrees: 0, millimetres: 30.2 })).toBe("30 mm"));

  it("a reason that says no more than the result is left out", () => {
    expect(["stays", "END of the motion"].map((reason) => reasonWords({ reason }))).toEqual([
      "",
      "END of the motion",
    ]);
  });
});
