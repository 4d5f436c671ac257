import { expect, it } from "vitest";
import type { StageDifferences } from "../net/protocol";
import { jointLines, comparedWords } from "./jointLines";

const compared = (id: number, joint_distance: number[], joint_angle_deg: number[]) => ({
  ...{ id, name: "walker", joints: ["Hip", "Knee", "Toe"], ticks: [4], by_tick: null },
  ...{ root_distance: [0], root_angle_deg: [0], distance: [0], distance_joint: [0] },
  ...{ angle_deg: [0], angle_joint: [0], joint_distance, joint_angle_deg },
});

const difference: StageDifferences = {
  ...{ stage: "a", other: "main", from: 4, to: 4, with_from: 4, first_difference: 4, note: "" },
  ...{ only_here: [], only_there: [] },
  actors: [compared(1, [9, 9, 9], [0, 0, 0]), compared(2, [0.0001, 0.25, 0.5], [0.01, 30, 2])],
};

it("lists the joints of the watched actor that differ, the farthest first", () => {
  expect(jointLines(difference, 2)).toEqual([
    { joint: "Toe", distance: "50.0", angle: "2.0" },
    { joint: "Knee", distance: "25.0", angle: "30.0" },
  ]);
});

it("says that no joint differs, and at which tick", () => {
  expect(comparedWords({ ...difference, first_difference: null }, 0)).toBe("No joint differs at tick 4.");
});

it("says that all differences are too small to be listed", () => {
  const small = { ...difference, actors: [compared(2, [0.0001, 0, 0], [0.01, 0, 0])] };
  const lines = jointLines(small, 2).length;
  expect(comparedWords(small, lines)).toBe(
    "No joint differs by half a millimetre, or a twentieth of a degree, at tick 4.",
  );
});

it("says where the second of two spans begins", () => {
  expect(comparedWords({ ...difference, to: 9, with_from: 30 }, 2)).toBe(
    "The largest differences in the ticks 4 to 9, beside those from 30 on:",
  );
});
