import { describe, expect, it } from "vitest";
import type { Cell } from "../../net/protocol";
import {
  type AlternativeText,
  alternativeTexts,
  enterField,
  setAlternatives,
  setTarget,
  setTransition,
  setWhen,
  targetText,
  type TransitionChange,
} from "./cellValues";

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

const text: AlternativeText = { ...way, to: "RUN", condition: "speed > 3", weight: "" };

describe("alternatives", () => {
  it("say only what the cell does not say already", () =>
    expect(
      setAlternatives(place, EITHER, [
        { ...text, blend: 0.25, enter: "match" },
        { ...text, to: "STAT", condition: "", curve: "quintic", action: "shout" },
      ]),
    ).toEqual([
      {
        kind: "set_cell",
        ...place,
        fields: {
          alternatives: [
            { to: "RUN", if: "speed > 3", enter: "match" },
            { to: "STAT", blend: { seconds: 0.2, curve: "quintic" }, action: "shout" },
          ],
        },
      },
    ]));

  it("of a cell that enters at a phase can enter at the beginning", () =>
    expect(setAlternatives(place, { ...WALK, enter: 0.3 }, [{ ...text, blend: 0.25 }])).toEqual([
      { kind: "set_cell", ...place, fields: { alternatives: [{ to: "RUN", if: "speed > 3", enter: 0 }] } },
    ]));

  it("keep what they say in another order", () => {
    const [first, last] = alternativeTexts({
      ...EITHER,
      alternatives: [
        { ...way, to: "RUN", condition: "speed > 2", action: "run" },
        { ...way, to: "HOP", condition: "speed > 1", enter: 0.5 },
      ],
    });
    expect(setAlternatives(place, EITHER, [last!, first!])).toMatchObject([
      {
        fields: {
          alternatives: [
            { to: "HOP", enter: 0.5 },
            { to: "RUN", action: "run" },
          ],
        },
      },
    ]);
  });

  it("with a weight are drawn by lot", () =>
    expect(
      setAlternatives(place, WALK, [
        { ...text, weight: "3" },
        { ...text, to: "STAT" },
      ]),
    ).toEqual([{ kind: "set_cell", ...place, fields: { alternatives: { RUN: 3, STAT: 1 } } }]));
});

describe("a cell's transition", () => {
  it("names its curve if the machine's is another one", () => {
    const curve = (change: TransitionChange, ofMachine: Cell["curve"]) =>
      setTransition(place, WALK, change, ofMachine)[0];
    expect(curve({ blend: 0.4 }, "cubic")).toMatchObject({ fields: { blend: 0.4 } });
    expect(curve({ blend: 0.4 }, "quintic")).toMatchObject({
      fields: { blend: { seconds: 0.4, curve: "cubic" } },
    });
    expect(curve({ curve: "quintic" }, "quintic")).toMatchObject({ fields: { blend: 0.25 } });
  });

  it("of a default becomes that of a cell of its own, which keeps the rest", () => {
    const fall = { ...WALK, source: "column default", written: ["*", "LEFT"], action: "cry" } as Cell;
    expect(setTransition(place, fall, { enter: 0.5 }, "cubic")).toEqual([
      {
        kind: "set_cell",
        ...place,
        text: "TLFT",
        fields: { when: "now", blend: { seconds: 0.25, curve: "cubic" }, action: "cry", enter: 0.5 },
      },
    ]);
    expect(setTransition({ ...place, state: "*" }, fall, { enter: 0.5 }, "cubic")).toEqual([
      { kind: "set_cell", ...place, state: "*", fields: { enter: 0.5 } },
    ]);
  });
});

describe("the phase of entry", () => {
  it("is a number, match, or nothing", () =>
    expect(["0.3", "match", " "].map(enterField)).toEqual([0.3, "match", null]));
  it("is between 0 and 1", () => expect(() => enterField("2")).toThrow("from 0 to 1"));
});
