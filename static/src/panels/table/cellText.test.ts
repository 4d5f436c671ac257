import { describe, expect, it } from "vitest";
import type { Cell, LayerInfo } from "../../net/protocol";
import { alternative, cell } from "../../net/types/examples";
import { cellSentence, glance, momentSign, alternativeLines, writtenText } from "./cellText";

describe("momentSign", () => {
  it.each([
    ["now", ""],
    ["end", "⇥"],
    ["marker left-down", "⟂ left-down"],
    ["window 0.2..0.6", "◫ .2–.6"],
  ])("%s: %s", (when, sign) => {
    expect(momentSign(when)).toBe(sign);
  });
});

describe("glance", () => {
  it("of a blank cell is empty", () => expect(glance(undefined)).toEqual({ to: "", others: 0, signs: [] }));

  it.each<[Partial<Cell>, string, string[]]>([
    [{ to: null }, "–", []],
    [{ to: "WALK", when: "now" }, "WALK", []],
    [{ to: "TLFT", when: "end", restart: true }, "TLFT!", ["⇥"]],
    [{ to: "JUMP", enter: "match", action: "jump" }, "JUMP", ["≈", "◆"]],
  ])("%j", (members, to, signs) => expect(glance(cell(members))).toEqual({ to, others: 0, signs }));

  it("counts alternatives", () => {
    const alternatives = ["JUMP", "FLY"].map((to) => alternative({ to }));
    expect(glance(cell({ to: "JUMP", alternatives })).others).toBe(2);
  });
});

describe("alternativeLines", () => {
  it("gives weights as chances", () => {
    const alternatives = [alternative({ to: "STAT", weight: 3 }), alternative({ to: "CSTP", weight: 1 })];
    expect(alternativeLines(cell({ to: "STAT", alternatives }))).toEqual([
      "STAT 75 %, blend 0.25 s",
      "CSTP 25 %, blend 0.25 s",
    ]);
  });

  it("gives conditions as they are written", () => {
    const alternatives = [
      alternative({ to: "JUMP", condition: "stamina > 10" }),
      alternative({ to: "STUP" }),
    ];
    expect(alternativeLines(cell({ to: "JUMP", alternatives }))).toEqual([
      "JUMP if stamina > 10, blend 0.25 s",
      "STUP otherwise, blend 0.25 s",
    ]);
  });
});

describe("cellSentence", () => {
  it("says where a default comes from", () => {
    expect(
      cellSentence(
        "WALK",
        "HIT",
        cell({ to: "FALL", blend: 0.1, source: "column default", written: ["*", "HIT"] }),
      ),
    ).toBe("WALK, HIT → FALL: at once, blend 0.10 s, from column default */HIT");
  });
});

describe("writtenText", () => {
  const layer = {
    rows: [
      ["state", "LEFT"],
      ["WALK", "TLFT! at end"],
    ],
    table: {
      "DOWN.CRCH": {
        LEFT: cell({ to: "DOWN.STUP", restart: true, when: "marker low" }),
        HIT: cell({ to: "FALL", source: "column default" }),
        OFF: cell({}),
      },
    },
  } as Partial<LayerInfo> as LayerInfo;

  it.each([
    ["WALK", "LEFT", "TLFT! at end"],
    ["DOWN.CRCH", "LEFT", "DOWN.STUP! at low"],
    ["DOWN.CRCH", "HIT", ""],
    ["DOWN.CRCH", "OFF", "-"],
    ["WALK", "HIT", ""],
  ])("%s/%s: %s", (state, event, text) => expect(writtenText(layer, state, event)).toBe(text));
});
