import { describe, expect, it } from "vitest";
import { layOut } from "./layout";
import { around, overlap, rectOf, stateWidth } from "./shapes";

const edge = (from: string, to: string) => ({ from, to, events: ["E"] });
const CHAIN = ["A", "B", "C", "D", "E", "F"];
const CHAIN_EDGES = CHAIN.slice(1).map((to, i) => edge(CHAIN[i]!, to));
const RING_EDGES = CHAIN.flatMap((from) => CHAIN.filter((to) => to !== from).map((to) => edge(from, to)));

const rects = (edges: ReturnType<typeof edge>[], aspect: number) =>
  [...layOut(CHAIN, edges, aspect)].map(([name, place]) =>
    rectOf({ name, ...place, width: stateWidth(name) }),
  );
const aspectOf = (edges: ReturnType<typeof edge>[], aspect: number): number => {
  const { left, right, top, bottom } = around(rects(edges, aspect));
  return (right - left) / (bottom - top);
};

describe("layOut", () => {
  it("lies down in a wide panel and stands up in a high one", () =>
    expect([aspectOf(CHAIN_EDGES, 4) > 1, aspectOf(CHAIN_EDGES, 0.25) < 1]).toEqual([true, true]));

  it("leaves out edges to states that do not exist", () =>
    expect([...layOut(["A"], [edge("A", "TLFG")], 1).keys()]).toEqual(["A"]));

  it.each([
    ["in layers", CHAIN_EDGES],
    ["on a ring, if all lead to all", RING_EDGES],
  ])("keeps states apart: %s", (_, edges) => {
    const all = rects(edges, 2);
    expect(all.filter((a, i) => all.slice(i + 1).some((b) => overlap(a, b)))).toEqual([]);
  });
});
