import { describe, expect, it } from "vitest";
import { layOut } from "./layout";
import { type Size, around, overlap, rectOf, stateWidth } from "./shapes";

const edge = (from: string, to: string) => ({ from, to, events: ["E"] });
const ROOM = { width: 400, height: 200 };
const chain = (states: readonly string[]) => states.slice(1).map((to, i) => edge(states[i]!, to));
const FEW = ["A", "B", "C", "D", "E", "F"];
const MANY = Array.from({ length: 12 }, (_, i) => `S${i}`);
const RING_EDGES = FEW.flatMap((from) => FEW.filter((to) => to !== from).map((to) => edge(from, to)));

const rects = (states: readonly string[], edges: ReturnType<typeof edge>[], room: Size) =>
  [...layOut(states, edges, room)].map(([name, place]) =>
    rectOf({ name, ...place, width: stateWidth(name) }),
  );
const sizeOf = (states: readonly string[], room: Size): Size => {
  const { left, right, top, bottom } = around(rects(states, chain(states), room));
  return { width: right - left, height: bottom - top };
};

describe("layOut", () => {
  it("lies down in a wide panel and stands up in a high one", () => {
    const [wide, high] = [sizeOf(FEW, { width: 400, height: 100 }), sizeOf(FEW, { width: 100, height: 400 })];
    expect([wide.width > wide.height, high.width < high.height]).toEqual([true, true]);
  });

  it("fills a panel that is larger than it must be", () => {
    const [least, more] = [
      sizeOf(FEW, { width: 600, height: 100 }),
      sizeOf(FEW, { width: 900, height: 100 }),
    ];
    expect([more.width / least.width > 1.3, more.width < 900]).toEqual([true, true]);
  });

  it("leads a long chain round a ring, where its layers would be too small to read", () => {
    const { width, height } = sizeOf(MANY, { width: 300, height: 160 });
    expect(Math.min(300 / width, 160 / height)).toBeGreaterThan(0.85);
  });

  it("leaves out edges to states that do not exist", () =>
    expect([...layOut(["A"], [edge("A", "TLFG")], ROOM).keys()]).toEqual(["A"]));

  it.each([
    ["in layers", chain(FEW)],
    ["on a ring, if all lead to all", RING_EDGES],
  ])("keeps states apart: %s", (_, edges) => {
    const all = rects(FEW, edges, ROOM);
    expect(all.filter((a, i) => all.slice(i + 1).some((b) => overlap(a, b)))).toEqual([]);
  });
});
