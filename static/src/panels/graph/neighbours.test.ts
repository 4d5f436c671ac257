import { describe, expect, it } from "vitest";
import { statesToDraw } from "./neighbours";

const many = Array.from({ length: 76 }, (_, i) => `S${i}`);
const edges = many.flatMap((from) => [
  { from, to: "S0", events: ["STOP"] },
  { from: "S0", to: from, events: [from] },
]);

describe("the states that are drawn", () => {
  it("are all of a small machine", () => expect(statesToDraw(["A", "B"], [], "A")).toEqual(["A", "B"]));
  it("are those next to the live one of a large machine", () =>
    expect(statesToDraw(many, edges, "S40")).toEqual(["S0", "S40"]));
  it("are never more than one can read", () => expect(statesToDraw(many, edges, "S0")).toHaveLength(18));
  it("hold the live one", () => expect(statesToDraw(many, edges, "S75")).toContain("S75"));
});
