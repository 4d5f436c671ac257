import { describe, expect, it } from "vitest";
import { laneRows } from "./laneRows";

describe("laneRows", () => {
  it("puts the layers one below the other", () => {
    const [base, arms] = laneRows([false, false], false).layers;
    expect(arms!.state).toBeGreaterThan(base!.events);
  });

  it("has no lane for actions before there was one", () =>
    expect(laneRows([false], false).actions).toBeNull());

  it("has states alone when it is folded", () => {
    const { actions, height } = laneRows([true, true], true);
    expect([actions, height < laneRows([false, false], false).height]).toEqual([null, true]);
  });

  it("folds one lane and moves the next up to it", () => {
    const [open, folded] = [laneRows([false, false], true), laneRows([true, false], true)];
    expect(folded.layers[1]!.state).toBeLessThan(open.layers[1]!.state);
    expect(open.height - folded.height).toBe(open.layers[1]!.state - folded.layers[1]!.state);
    expect(folded.actions).not.toBeNull();
  });

  it("makes each layer at least so high, folded or not", () => {
    const { layers, height } = laneRows([true, false], false, 60);
    expect(layers[1]!.state - layers[0]!.state).toBe(60);
    expect(height - layers[1]!.state).toBe(60);
  });

  it("puts actions below everything", () => {
    const { actions, height, layers } = laneRows([false, false], true);
    expect([actions! > layers[1]!.events, height > actions!]).toEqual([true, true]);
  });
});
