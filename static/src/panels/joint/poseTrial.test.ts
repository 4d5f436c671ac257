import { expect, test } from "vitest";
import { trialWords } from "./poseTrial";

test("says how a trial went", () => {
  expect(trialWords("Hand", { reached: true, distance: 0, clamped: {} })).toBe("trial: Hand reaches");
  expect(trialWords("Hand", { reached: false, distance: 0.125, clamped: { Elbow: 12.34 } })).toBe(
    "trial: Hand stays 12.5 cm away; clamped: Elbow by 12.3°",
  );
});
