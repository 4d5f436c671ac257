// @vitest-environment happy-dom
import { describe, expect, it, vi } from "vitest";
import type { LayerInfo } from "../../net/protocol";
import { columns, linesOf } from "./drawTable";

describe("columns", () => {
  const layer = {
    rows: [["state", "WAVE", "END"]],
    states: [{ name: "REST" }],
    table: { REST: { HIT: { to: "REST" } } },
  } as unknown as LayerInfo;

  it("are those that the layer answers, in the machine's order", () => {
    expect(columns(layer, ["FORWARD", "HIT", "WAVE", "END"])).toEqual(["HIT", "WAVE", "END"]);
  });
});

describe("lines", () => {
  const named = (name: string, outer = "") => ({ name, outer, motion: null });
  const layer = {
    states: [named("STAND"), named("FIGHT.DOWN.FALL", "FIGHT.DOWN"), named("FIGHT.HIT", "FIGHT")],
    composites: [named("FIGHT"), named("FIGHT.DOWN", "FIGHT")],
    table: {},
  } as unknown as LayerInfo;
  const texts = (shown: Record<string, string>, fold = vi.fn()) =>
    linesOf(layer, layer.states, [], { shown: new Map(Object.entries(shown)), fold, goTo: null }).map(
      ({ draw }) => draw(),
    );

  it("have the heads of all sub-machines around a state", () => {
    const words = texts({}).map((row) => row.textContent);
    expect(words).toEqual(["STAND", "FIGHT", "FIGHT.DOWN", "FALL", "HIT"]);
  });

  it("have one line for a folded sub-machine", () => {
    const words = texts({ "FIGHT.DOWN.FALL": "FIGHT", "FIGHT.HIT": "FIGHT" }).map((row) => row.textContent);
    expect(words).toEqual(["STAND", "FIGHT, 2 states"]);
  });

  it("unfold by the button of their head", () => {
    const fold = vi.fn();
    texts({ "FIGHT.DOWN.FALL": "FIGHT.DOWN" }, fold)[2]!.querySelector("button")!.click();
    expect(fold).toHaveBeenCalledWith("FIGHT.DOWN", false);
  });
});
