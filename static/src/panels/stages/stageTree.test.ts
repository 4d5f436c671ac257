import { expect, it } from "vitest";
import { stageInfo } from "../../net/types/examples";
import { nowWords, originWords, spanOf, treeOf } from "./stageTree";

const main = stageInfo({ id: "main" });
const origin = (stage: string, tick: number) => ({ stage, tick, is_there: true });
const late = stageInfo({ id: "late", origin: origin("main", 90) });
const early = stageInfo({ id: "early", origin: origin("main", 30) });
const child = stageInfo({ id: "child", origin: origin("late", 95) });

it("puts forks below their origins in the order of their ticks, and main first", () => {
  const other = stageInfo({ id: "other", made: 1 });
  expect(treeOf([child, other, late, early, main]).map(({ stage, depth }) => [stage.id, depth])).toEqual([
    ["main", 0],
    ["early", 1],
    ["late", 1],
    ["child", 2],
    ["other", 0],
  ]);
});

it("shows a fork whose origin was deleted", () => {
  const orphan = stageInfo({ origin: { stage: "late", tick: 5, is_there: false } });
  expect(treeOf([main, orphan])).toHaveLength(2);
  expect(originWords(orphan, [main, orphan])).toBe("left a deleted stage at tick 5 · no input");
});

it("says what differs, and who has paused", () => {
  const newest_input = { number: 7, tick: 40, text: "JUMP to walker" };
  expect(originWords({ ...early, inputs: 2, newest_input }, [main, early])).toBe(
    "left main at tick 30 · 2 inputs, the newest: JUMP to walker",
  );
  const changed = { what: "paused" as const, by: "Ada", viewer: 3, tick: 50 };
  expect(nowWords({ ...early, paused: true, changed, head: 50 })).toBe("tick 50 · paused by Ada · 1 viewer");
});

it("draws a fork from its origin's tick on, all on one scale", () => {
  const all = [
    { ...main, head: 200 },
    { ...late, head: 150 },
  ];
  expect(all.map((stage) => spanOf(stage, all))).toEqual([
    { from: 0, to: 1 },
    { from: 0.45, to: 0.75 },
  ]);
});
