import { expect, test } from "vitest";
import { compareSpans } from "./compareSpans";

const runs = [
  { start: 0, end: 59, state: "STAND" },
  { start: 60, end: 119, state: "WALK" },
  { start: 120, end: 200, state: "STAND" },
];

test("states stand side by side, cut to their spans, and the different ones are marked", () => {
  const lines = compareSpans([{ from: 30, to: 89 }, runs], [{ from: 90, to: 134 }, runs], 60);
  expect(lines).toEqual([
    { first: "STAND 0.50 s", second: "WALK 0.50 s", differs: true },
    { first: "WALK 0.50 s", second: "STAND 0.25 s", differs: true },
  ]);
});

test("a span is like itself, and a longer one has lines of its own", () => {
  const [short, long] = [
    { from: 0, to: 59 },
    { from: 0, to: 119 },
  ];
  expect(compareSpans([short, runs], [short, runs], 60).map(({ differs }) => differs)).toEqual([false]);
  expect(compareSpans([short, runs], [long, runs], 60)[1]).toEqual({
    first: "",
    second: "WALK 1.00 s",
    differs: true,
  });
});
