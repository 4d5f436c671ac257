import { describe, expect, it } from "vitest";
import { refusal } from "./editing";
import { ApiError, problemOf } from "../net/api";

const place = { layer: "base", state: "WALK", event: "LEFT" };

describe("refusal", () => {
  it("is what the verifier says", () => {
    const findings = [
      { kind: "undefined state", severity: "error" as const, message: "TLXT is no state", line: 36 },
    ];
    expect(refusal(problemOf(422, { detail: "refused", findings }), place)).toEqual(findings);
  });

  it("is the reader's own words at the cell, with their line", () => {
    const error = new ApiError(
      422,
      "machine.yaml, line 45: the next state of WALK/JUMP is set under `cells`; change it there",
    );
    expect(refusal(error, place)).toEqual([
      {
        kind: "refused",
        severity: "error",
        message: "the next state of WALK/JUMP is set under `cells`; change it there",
        line: 45,
        ...place,
        replay: [],
      },
    ]);
  });
});
