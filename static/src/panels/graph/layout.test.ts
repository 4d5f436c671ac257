import { describe, expect, it } from "vitest";
import { layOut } from "./layout";
import { type Size, around, overlap, rectOf, stateWidth } from "./shapes";

const edge = (from: string, to: string) => ({ from, to, events: ["E"] });
const ROOM = { width: 400, height: 200 };
const CHAIN = ["A", "B", "C", "D", "E", "F"];
const CHAIN_EDGES = CHAIN.slice(1).map((to, i) => edge(CHAIN[i]!, to));
const RING_EDGES = CHAIN.flatMap((from) => CHAIN.filter((to) => to !== from).map((to) => edge(from, to)));

const rects = (edges: ReturnType<typeof edge>[], room: Size) =>
  [...layOut(CHAIN, edges, room)].map(([name, place]) => rectOf({ name, ...place, width: stateWidth(name) }));
const sizeOf = (room: Size): Size => {
  const { left, right, top, bottom } = around(rects(CHAIN_EDGES, room));
  return { width: right - left, height: bottom - top };
};

describe("layOut", () => {
  it("lies down in a wide panel and stands up in a high one", () => {
    const [wide, high] = [sizeOf({ width: 400, height: 100 }), sizeOf({ width: 100, height: 400 })];
    expect([wide.width > wide.height, high.width < high.height]).toEqual([true, true]);
  });

  it("fills a panel that is larger than it must be", () => {
    const [least, more] = [sizeOf({ width: 600, height: 100 }), sizeOf({ width: 900, height: 100 })];
    expect([more.width / least.width > 1.3, more.width < 900]).toEqual([true, true]);
  });

  it("leaves out edges to states that do not exist", () =>
    expect([...layOut(["A"], [edge("A", "TLFG")], ROOM).keys()]).toEqual(["A"]));

  it.each([
    ["in layers", CHAIN_EDGES],
    ["on a ring, if all lead to all", RING_EDGES],
  ])("keeps states apart: %s", (_, edges) => {
    const all = rects(edges, ROOM);
    expect(all.filter((a, i) => all.slice(i + 1).some((b) => overlap(a, b)))).toEqual([]);
  });
});
