import { describe, expect, it } from "vitest";
import { refusal } from "./editAnswer";

const place = { layer: "base", state: "WALK", event: "LEFT" };

describe("refusal", () => {
  it("is what the verifier says", () => {
    const finding = {
      kind: "undefined state",
      severity: "error" as const,
      message: "TLXT is no state",
      subject: "TLXT",
      line: 36,
      ...place,
      replay: [],
      ticks: 0,
    };
    expect(refusal("refused", [finding], place)).toEqual({
      kind: "refused",
      words: "refused",
      findings: [finding],
    });
  });

  it("is the reader's own words at the cell, with their line", () => {
    const words = "machine.yaml, line 45: the next state of WALK/JUMP is set under `cells`; change it there";
    expect(refusal(words, [], place).findings).toEqual([
      {
        kind: "refused",
        severity: "error",
        message: "the next state of WALK/JUMP is set under `cells`; change it there",
        subject: "the next state of WALK/JUMP is set under `cells`; change it there",
        line: 45,
        ...place,
        replay: [],
        ticks: 0,
      },
    ]);
  });
});
