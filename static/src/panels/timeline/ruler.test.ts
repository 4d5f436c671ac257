import { expect, it } from "vitest";
import { rulerMarks } from "./ruler";

it.each([
  ["ten seconds", { from: 0, to: 600 }, 700, ["0 s", "1 s", "2 s"]],
  ["less than a second", { from: 60, to: 96 }, 800, ["1.00 s", "1.05 s", "1.10 s"]],
  ["minutes", { from: 3600, to: 3600 + 60 * 240 }, 640, ["1:00", "1:30", "2:00"]],
])("marks round seconds of %s", (_, span, width, words) =>
  expect(
    rulerMarks(span, 60, width)
      .slice(0, 3)
      .map((mark) => mark.words),
  ).toEqual(words),
);

it("marks stand at their ticks, and leave room for their words", () => {
  const span = { from: 130, to: 1330 };
  const marks = rulerMarks(span, 60, 400);
  expect(marks[0]).toEqual({ tick: 300, words: "5 s" });
  const apart = ((marks[1]!.tick - marks[0]!.tick) / (span.to - span.from)) * 400;
  expect(apart).toBeGreaterThanOrEqual(64);
});
