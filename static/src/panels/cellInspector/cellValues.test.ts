import { describe, expect, it } from "vitest";
import type { Cell } from "../../net/protocol";
import { enterField, setAlternatives, setTarget, setWhen, targetText } from "./cellValues";

const place = { layer: "base", state: "WALK", event: "LEFT" };
const WALK: Cell = {
  to: "TLFT",
  when: "now",
  blend: 0.25,
  curve: "cubic",
  enter: 0,
  restart: false,
  action: null,
  source: "cell",
  line: 1,
  written: ["WALK", "LEFT"],
  alternatives: [],
};
const way = {
  condition: "",
  weight: null,
  blend: 0.2,
  curve: "cubic",
  enter: 0,
  restart: false,
  action: null,
} as const;
const EITHER: Cell = {
  ...WALK,
  to: null,
  alternatives: [
    { ...way, to: "RUN", condition: "speed > 2" },
    { ...way, to: "STAT" },
  ],
};

describe("a cell's target", () => {
  it("is written as in the table", () => {
    expect(targetText(undefined)).toBe("");
    expect(targetText({ ...WALK, to: null })).toBe("-");
    expect(targetText({ ...WALK, restart: true })).toBe("TLFT!");
  });

  it("keeps its moment", () =>
    expect(setTarget(place, { ...WALK, when: "marker left" }, "STAT")).toEqual([
      { kind: "set_cell", ...place, text: "STAT at left" },
    ]));

  it("takes the place of alternatives", () =>
    expect(setTarget(place, EITHER, "STAT")).toEqual([
      { kind: "set_cell", ...place, text: "STAT", fields: { alternatives: null } },
    ]));
});

describe("a cell's moment", () => {
  it("stands in the table if it can", () =>
    expect(setWhen(place, WALK, "end")).toEqual([
      { kind: "set_cell", ...place, text: "TLFT at end", fields: { when: null } },
    ]));

  it("stands below the cells if it is a window", () =>
    expect(setWhen(place, WALK, "window 0.2..0.8")).toEqual([
      { kind: "set_cell", ...place, text: "TLFT", fields: { when: "window 0.2..0.8" } },
    ]));

  it("of alternatives stands below the cells", () =>
    expect(setWhen(place, EITHER, "end")).toEqual([{ kind: "set_cell", ...place, fields: { when: "end" } }]));
});

describe("alternatives", () => {
  it("keep what the form does not show", () =>
    expect(setAlternatives(place, EITHER, [{ to: "RUN", condition: "speed > 3", weight: "" }])).toEqual([
      {
        kind: "set_cell",
        ...place,
        fields: { alternatives: [{ to: "RUN", if: "speed > 3", blend: 0.2 }] },
      },
    ]));

  it("with a weight are drawn by lot", () =>
    expect(
      setAlternatives(place, undefined, [
        { to: "RUN", condition: "", weight: "3" },
        { to: "STAT", condition: "", weight: "" },
      ]),
    ).toEqual([{ kind: "set_cell", ...place, fields: { alternatives: { RUN: 3, STAT: 1 } } }]));
});

describe("the phase of entry", () => {
  it("is a number, match, or nothing", () =>
    expect(["0.3", "match", " "].map(enterField)).toEqual([0.3, "match", null]));
  it("is between 0 and 1", () => expect(() => enterField("2")).toThrow("from 0 to 1"));
});
