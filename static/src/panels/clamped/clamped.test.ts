import { expect, test } from "vitest";
import { clampedWords } from "./clamped";

test("says by how much each joint was clamped", () => {
  expect(clampedWords([])).toBe("limits: all joints inside");
  expect(
    clampedWords([
      { joint: "Knee", angle_deg: 12.34, distance: 0, by: "motion" },
      { joint: "Slide", angle_deg: 0, distance: 0.025, by: "motion" },
      { joint: "Elbow", angle_deg: 3, distance: 0, by: "solver" },
    ]),
  ).toBe("clamped: Knee by 12.3°; Slide by 2.5 cm; Elbow by 3.0° (reaching)");
});
