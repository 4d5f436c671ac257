import { expect, test } from "vitest";
import { differenceLines } from "./differenceLines";

const NOTHING = { version: 3, since: 2, names: [], cells: [], parts: [] };

test("a changed cell leads to its place", () => {
  const cell = { layer: "base", state: "WALK", event: "LEFT" };
  expect(differenceLines({ ...NOTHING, cells: [{ ...cell, before: "TLFT", after: "STAT at end" }] })).toEqual(
    [{ words: "WALK, LEFT", before: "TLFT", after: "STAT at end", cell }],
  );
});

test("a cell of a layer names its layer, and one that is gone leads nowhere", () => {
  const gone = { layer: "head", state: "NOD", event: "END", before: "REST", after: null };
  expect(differenceLines({ ...NOTHING, cells: [gone] })).toEqual([
    { words: "head: NOD, END", before: "REST", after: "", cell: null },
  ]);
});

test("a new state, and another part", () => {
  const names = [{ kind: "state" as const, layer: "base", before: null, after: "RUN" }];
  const parts = [{ part: ["parameter", "pace", "max"], before: "1", after: "2" }];
  expect(differenceLines({ ...NOTHING, names, parts })).toEqual([
    { words: "state", before: null, after: "RUN", cell: null },
    { words: "parameter / pace / max", before: "1", after: "2", cell: null },
  ]);
});
