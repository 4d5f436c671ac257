import { describe, expect, it } from "vitest";
import { partOf } from "./content";

const nodes = Array.from({ length: 76 }, (_, i) => ({ name: `S${i}`, facts: "", inner: [] }));
const edges = [
  { from: "S1", to: "S11", events: ["GO"] },
  { from: "S1", to: "S2", events: ["GO"] },
];
const part = (words: string) => partOf({ nodes, edges, initial: "S0" }, "S1", words);
const names = (words: string): string[] => part(words).nodes.map(({ name }) => name);

describe("the part of a graph that is drawn", () => {
  it("has the states that the filter names, wherever the character is", () =>
    expect(names("s75 s12")).toEqual(["S12", "S75"]));
  it("has the arrows between them", () => expect(part("S1").edges).toEqual([edges[0]]));
  it("has no more than can be read", () => expect(names("4 5 6 7 8 9")).toHaveLength(40));
  it("is around the live state where nothing is named", () =>
    expect([names(""), names("jump")]).toEqual([
      ["S1", "S2", "S11"],
      ["S1", "S2", "S11"],
    ]));
});
