import { expect, it } from "vitest";
import { fits, levelsOf, standsFor } from "./collapses";

const chain = { vertices: [3, 2, 1], onto: [2, 1, 0], steps: [0, 1, 2] };

it("a vertex that collapses leads on to the one that is left", () => {
  expect([...standsFor(chain, 0, 4)]).toEqual([0, 1, 2, 3]);
  expect([...standsFor(chain, 2, 4)]).toEqual([0, 1, 1, 1]);
  expect([...standsFor(chain, 9, 4)]).toEqual([0, 0, 0, 0]);
});

it("collapses that do not fit a primitive are told", () => {
  expect(fits(chain, 4)).toBe(true);
  expect(fits(chain, 3)).toBe(false);
  expect(fits({ ...chain, onto: [2, 3, 0] }, 4)).toBe(false); // onto one that is gone
  expect(fits({ ...chain, vertices: [3, 3, 1] }, 4)).toBe(false); // twice
  expect(fits({ ...chain, onto: [3, 1, 0] }, 4)).toBe(false); // onto itself
  expect(fits({ ...chain, steps: [1, 0, 2] }, 4)).toBe(false);
  expect(fits({ ...chain, steps: [1, 2] }, 4)).toBe(false);
});

it("levels rise, or there are none", () => {
  const said = (levels: unknown): unknown => ({ statwalk: { levels } });
  expect(levelsOf(said([[3, 0.1], [5, 0.1]]))).toEqual([
    { steps: 3, error_m: 0.1 },
    { steps: 5, error_m: 0.1 },
  ]); // prettier-ignore
  for (const wrong of [
    [
      [3, 0.1],
      [3, 0.2],
    ],
    [
      [3, 0.2],
      [5, 0.1],
    ],
    [[3, "0.1"]],
    [[3]],
    [7],
    { a: 1 },
    null,
  ])
    expect(levelsOf(said(wrong))).toEqual([]);
  expect(levelsOf(undefined)).toEqual([]);
});
