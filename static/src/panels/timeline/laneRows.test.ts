import { describe, expect, it } from "vitest";
import { laneRows } from "./laneRows";

describe("laneRows", () => {
  it("puts the layers one below the other", () => {
    const [base, arms] = laneRows(2, false).layers;
    expect(arms!.state).toBeGreaterThan(base!.events);
  });

  it("has no lane for actions before there was one", () => expect(laneRows(1, false).actions).toBeNull());

  it("puts actions below everything", () => {
    const { actions, height, layers } = laneRows(2, true);
    expect([actions! > layers[1]!.events, height > actions!]).toEqual([true, true]);
  });
});
