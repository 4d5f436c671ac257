import { describe, expect, it } from "vitest";
import type { LayerInfo } from "../../net/protocol";
import { columns } from "./drawTable";

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
