import { describe, expect, it } from "vitest";
import { leadArrows, nearest } from "./arrows";
import { type Box, pointAt, rectOf } from "./shapes";

const box = (name: string, x: number, y: number): [string, Box] => [name, { name, x, y, width: 60 }];
const edge = (from: string, to: string) => ({ from, to, events: ["E"] });
const TIMES = Array.from({ length: 41 }, (_, i) => i / 40);

describe("leadArrows", () => {
  it("leads an arrow around a box between two others", () => {
    const boxes = new Map([box("A", 0, 0), box("B", 200, 0), box("C", 400, 0)]);
    const [arrow] = leadArrows([edge("A", "C")], boxes);
    const { left, right, top, bottom } = rectOf(boxes.get("B")!);
    const inside = TIMES.map((t) => pointAt(arrow!.curve, t)).filter(
      ({ x, y }) => x > left && x < right && y > top && y < bottom,
    );
    expect(inside).toEqual([]);
  });

  it("keeps the two arrows of a pair apart", () => {
    const boxes = new Map([box("A", 0, 0), box("B", 200, 0)]);
    const [there, back] = leadArrows([edge("A", "B"), edge("B", "A")], boxes);
    const [up, down] = [pointAt(there!.curve, 0.5).y, pointAt(back!.curve, 0.5).y];
    expect(Math.abs(up - down)).toBeGreaterThan(20);
  });

  it("leaves out arrows to states that are not drawn", () =>
    expect(leadArrows([edge("A", "B")], new Map([box("A", 0, 0)]))).toEqual([]));
});

describe("the nearest arrow", () => {
  const boxes = new Map([box("A", 0, 0), box("B", 0, 300), box("C", 100, 300)]);
  const arrows = leadArrows([edge("A", "B"), edge("B", "A"), edge("A", "C")], boxes);
  const at = (x: number, y: number): string => Object.values(nearest(arrows, { x, y })!).slice(0, 2).join();
  it("is told from the one beside it", () => {
    const sides = [at(-9, 150), at(9, 150)];
    expect(new Set(sides)).toEqual(new Set(["A,B", "B,A"]));
  });
  it("may be far away", () => expect(at(400, 300)).toBe("A,C"));
  it("is none where no arrow is", () => expect(nearest([], { x: 0, y: 0 })).toBeNull());
});
