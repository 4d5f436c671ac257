import { expect, test } from "vitest";
import { share } from "./blendCurve";

test.each(["cubic", "quintic"] as const)("a %s begins at the old motion and ends at the new one", (curve) => {
  expect([0, 1].map((t) => share(curve, t))).toEqual([0, 1]);
});

test("halfway a cubic shows half of each", () => expect(share("cubic", 0.5)).toBe(0.5));

test("a quintic is early, and soft at its end", () => {
  expect(share("quintic", 0.5)).toBe(0.8125);
  expect(1 - share("quintic", 0.99)).toBeLessThan(1e-7);
});
