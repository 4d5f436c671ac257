import { describe, expect, it } from "vitest";
import type { CarriedClip } from "../../net/protocol";
import { carriedText, sorted } from "./carriedText";

const REPORT: CarriedClip = {
  character: "robot-walk",
  clip: "walk",
  duration: 1,
  root: "Hips",
  bones: { Hips: { source: "hip", target: "Hips" }, Head: { source: "head", target: "Head" } },
  missing: [],
  unmapped_source: [],
  unmapped_target: [],
  scale: 1,
  notes: [],
};

describe("the report of a capture", () => {
  it("is short when all joints move", () => expect(carriedText(REPORT, 4)).toBe("2 bones carried over."));

  it("names joints that do not, and counts the rest", () => {
    const unmapped = { unmapped_target: ["a", "b", "c", "d", "e", "f"], unmapped_source: ["tail"] };
    expect(carriedText({ ...REPORT, ...unmapped }, 4)).toBe(
      "2 bones carried over. The capture does not move a, b, c, d and 2 more. Nothing takes the motion of tail.",
    );
  });

  it("ends with the notes", () =>
    expect(carriedText({ ...REPORT, notes: ["the first frame is left out"] }, 4)).toBe(
      "2 bones carried over. The first frame is left out.",
    ));

  it("names bones of the body first, and strange joints of the capture", () => {
    const report = { ...REPORT, unmapped_source: ["toe", "q7"], unmapped_target: ["eye", "arm", "lid"] };
    const bones = (known: Record<string, string>): Parameters<typeof sorted>[1] => ({
      character: "",
      bones: known,
      needed: [],
      known: [],
    });
    const found = sorted(report, bones({ LeftToes: "toe" }), bones({ LeftUpperArm: "arm" }));
    expect(found.unmapped_source).toEqual(["q7", "toe"]);
    expect(found.unmapped_target).toEqual(["arm", "eye", "lid"]);
  });
});
