import { describe, expect, it } from "vitest";
import { layoutGraph } from "./layout";
import { curve } from "./shapes";

const edge = (from: string, to: string) => ({ from, to, events: ["E"] });
const CHAIN = ["A", "B", "C", "D", "E", "F"];
const CHAIN_EDGES = CHAIN.slice(1).map((to, i) => edge(CHAIN[i]!, to));

describe("layoutGraph", () => {
  it("gives every state a place inside the picture", () => {
    const { states, width, height } = layoutGraph(CHAIN, CHAIN_EDGES, 1);
    expect(states.map((state) => state.name)).toEqual(CHAIN);
    for (const { x, y } of states) expect(x > 0 && y > 0 && x < width && y < height).toBe(true);
  });

  it("lies down in a wide panel and stands up in a high one", () => {
    const [wide, high] = [layoutGraph(CHAIN, CHAIN_EDGES, 4), layoutGraph(CHAIN, CHAIN_EDGES, 0.25)];
    expect([wide.width > wide.height, high.height > high.width]).toEqual([true, true]);
  });

  it("draws an arrow from a state to itself", () => {
    expect(layoutGraph(["A"], [edge("A", "A")], 1).edges[0]!.path).toContain("C");
  });

  it("leaves out arrows to states that do not exist", () => {
    expect(layoutGraph(["A"], [edge("A", "TLFG")], 1).edges).toEqual([]);
  });

  it("keeps both arrows of a pair", () => {
    const { edges } = layoutGraph(["A", "B"], [edge("A", "B"), edge("B", "A")], 1);
    expect(new Set(edges.map(({ path }) => path)).size).toBe(2);
  });
});

describe("a machine where all states lead to all others", () => {
  const all = CHAIN.flatMap((from) => CHAIN.filter((to) => to !== from).map((to) => edge(from, to)));
  const { states, edges, width, height } = layoutGraph(CHAIN, all, 2);

  it("stands on a ring inside the picture, in the order of the table", () => {
    expect(states[0]!.y).toBe(Math.min(...states.map(({ y }) => y)));
    for (const { x, y, width: own } of states)
      expect(x - own / 2 >= 0 && x + own / 2 <= width && y > 0 && y < height).toBe(true);
  });

  it("keeps neighbours apart", () => {
    const apart = states.every((a, i) =>
      states
        .slice(i + 1)
        .every((b) => Math.abs(a.x - b.x) >= (a.width + b.width) / 2 || Math.abs(a.y - b.y) >= 28),
    );
    expect(apart).toBe(true);
  });

  it("has all arrows", () => expect(edges).toHaveLength(30));
});

describe("curve", () => {
  it("starts and ends where its points do", () => {
    const path = curve([
      { x: 0, y: 0 },
      { x: 5, y: 5 },
      { x: 10, y: 0 },
    ]);
    expect([path.startsWith("M0.0 0.0"), path.endsWith("10.0 0.0")]).toEqual([true, true]);
  });
});
