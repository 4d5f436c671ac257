import * as THREE from "three";
import { describe, expect, it } from "vitest";
import type { Point } from "../../state/points";
import { type Frame, placeOf, valueAt } from "./handlePlace";

const rounded = (point: Point | null): number[] | null =>
  point && point.map((x) => Math.round(x * 1e6) / 1e6 + 0);
/** An actor at (10, 0, 5) that faces +X. */
const root = new THREE.Matrix4().makeRotationY(Math.PI / 2).setPosition(10, 0, 5);
const on = (frame: Partial<Frame>): Frame => ({ root: null, from: null, away: 0.5, ...frame });

describe("the place of a handle", () => {
  it("is the point itself, if the point is on the stage", () => {
    expect(placeOf([1, 2, 3], on({}))).toEqual([1, 2, 3]);
  });

  it("goes with the actor, if the point is in model space", () => {
    expect(rounded(placeOf([0, 1, 2], on({ root })))).toEqual([12, 1, 5]);
  });

  it("lies along a direction, at its distance from where the direction begins", () => {
    expect(rounded(placeOf([0, 3, 4], on({ from: [1, 1, 1] })))).toEqual([1, 1.3, 1.4]);
  });

  it("turns with the actor, if the direction is in model space", () => {
    expect(rounded(placeOf([0, 0, 1], on({ root, from: [10, 1, 5] })))).toEqual([10.5, 1, 5]);
  });
});

describe("the value of a handle", () => {
  it.each([on({}), on({ root }), on({ from: [1, 1, 1] }), on({ root, from: [10, 1.6, 5] })])(
    "is what the place was made of %#",
    (frame) => {
      const value: Point = [0.6, 0, 0.8];
      expect(rounded(valueAt(placeOf(value, frame), frame))).toEqual(value);
    },
  );

  it("has length 1, wherever a direction's handle is dragged", () => {
    expect(rounded(valueAt([4, 5, 1], on({ from: [1, 1, 1] })))).toEqual([0.6, 0.8, 0]);
  });

  it("is none where the direction begins", () => {
    expect(valueAt([1, 1, 1], on({ from: [1, 1, 1] }))).toBeNull();
  });
});
