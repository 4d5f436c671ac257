import { expect, test } from "vitest";
import type { CameraMode } from "../../state/viewpoint";
import { awayTo, sideFrom, sideOf, turnTo } from "./cameraModes";

const lookingAt = (mode: CameraMode, heading: number): number[] => awayTo(sideOf(mode)!, heading).toArray();

test("front, side and top stand where their names say, and turn with the character", () => {
  const [along, across] = [lookingAt("front", 0), lookingAt("front", Math.PI / 2)];
  expect(along[2]).toBeGreaterThan(0.99);
  expect(across[0]).toBeGreaterThan(0.99);
  expect(lookingAt("side", 0)[0]).toBeGreaterThan(0.99); // +X is the character's left
  expect(lookingAt("top", 1)[1]).toBeGreaterThan(0.999);
});

test("follow and free look from where the user has put them", () => {
  expect([sideOf("follow"), sideOf("free")]).toEqual([null, null]);
});

test("the side is found again from the place", () => {
  const side = sideFrom(awayTo({ azimuth: 0.3, elevation: -0.2 }, 1.1), 1.1);
  expect(side.azimuth).toBeCloseTo(0.3);
  expect(side.elevation).toBeCloseTo(-0.2);
});

test("a turn takes the short way", () => {
  expect(turnTo(3, -3)).toBeCloseTo(2 * Math.PI - 6);
  expect(turnTo(0.5, 0.25)).toBe(-0.25);
});
