import { describe, expect, it } from "vitest";
import { verdict } from "../../net/types/examples";
import { verdictLine } from "./verdictLine";

describe("verdictLine", () => {
  it("tells what was taken", () => expect(verdictLine(verdict({}))).toBe("JUMP: WALK → JUMP"));

  it("tells a stay", () => expect(verdictLine(verdict({ to: "" }))).toBe("JUMP: stays in WALK"));

  it("tells why it was dropped", () => {
    expect(verdictLine(verdict({ verdict: "dropped", to: "", reason: "blank cell" }))).toBe(
      "JUMP: dropped in WALK, blank cell",
    );
  });
});
