import { describe, expect, it } from "vitest";
import { planBones } from "./bones";

describe("planBones", () => {
  it("draws every joint of a model without skins", () => {
    expect(planBones({ nodes: [0, 1, 2], parents: [-1, 0, 0] }, new Set())).toEqual({
      joints: [0, 1, 2],
      segments: [
        [0, 1],
        [0, 2],
      ],
    });
  });

  it("leaves meshes and scene nodes out where a skin names its joints", () => {
    // nodes 5 (scene), 9 (hip), 7 (mesh), 8 (leg): joints in this order, the skin names 9 and 8
    const plan = planBones({ nodes: [5, 9, 7, 8], parents: [-1, 0, 0, 1] }, new Set([9, 8]));
    expect(plan).toEqual({ joints: [1, 3], segments: [[1, 3]] });
  });

  it("draws a muscle bone without a segment", () => {
    const plan = planBones({ nodes: [0, 1, 2], parents: [-1, 0, 0], muscle_bones: [2] }, new Set([0, 1, 2]));
    expect(plan).toEqual({ joints: [0, 1, 2], segments: [[0, 1]] });
  });

  it("bridges a joint that is not drawn", () => {
    expect(planBones({ nodes: [0, 1, 2], parents: [-1, 0, 1] }, new Set([0, 2])).segments).toEqual([[0, 2]]);
  });
});
