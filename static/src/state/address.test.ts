// @vitest-environment happy-dom
import { beforeEach, expect, it } from "vitest";
import { type Address, addressWith, readAddress } from "./address";

const none: Address = {
  ...{ stage: null, opening: null, actor: null, layer: null, tick: null, why: null },
  ...{ camera: null, view: null },
};

beforeEach(() => history.replaceState(null, "", "/?quality=low"));

it("writes and reads the same parts, and keeps others", () => {
  const whole: Address = {
    ...{ stage: "a1", opening: { machine: "walker" }, actor: 3, layer: "head", tick: 77, why: 70 },
    ...{ camera: [0, 1.25, 3, 0, 1, 0], view: "free" },
  };
  const { search } = addressWith(whole);
  expect(readAddress(search)).toEqual(whole);
  expect(search).toContain("quality=low");
});

it("leaves out what is as the page shows it anyway", () => {
  history.replaceState(null, "", addressWith({ ...none, stage: "a1", tick: 5 }));
  expect(addressWith(none).search).toBe("?quality=low");
});

it("reads wrong parts as left out", () => {
  expect(readAddress("?actor=x&tick=-4&why=no&camera=1,2&view=up")).toEqual(none);
});
