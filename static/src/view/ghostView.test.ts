import { PerspectiveCamera } from "three";
import { expect, it } from "vitest";
import { isInPicture } from "./ghostView";

/** At the origin; it looks along -Z, 45° to each side. */
const camera = new PerspectiveCamera(90, 1, 0.1, 100);

it.each([
  { at: [0, 0, -5], seen: true },
  { at: [4.9, 0, -5], seen: true },
  { at: [5.1, 0, -5], seen: false },
  { at: [0, 0, 5], seen: false },
  { at: [9, 0, -5, 0, -4, -5], seen: true },
])("a ghost with joints at $at is in the picture: $seen", ({ at, seen }) => {
  expect(isInPicture(Float32Array.from(at), camera)).toBe(seen);
});
