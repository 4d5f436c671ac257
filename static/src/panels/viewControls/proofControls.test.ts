import { expect, test } from "vitest";
import { differenceWords } from "./proofControls";

test("a difference is told in millimetres, and a reason as it is", () => {
  expect(differenceWords(4.1e-6)).toBe("GPU and server differ by at most 0.004 mm");
  expect(differenceWords(NaN)).toContain("NaN");
  expect(differenceWords("")).toBe("comparing …");
  expect(differenceWords("no such stage")).toBe("no such stage");
});
