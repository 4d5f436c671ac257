import { describe, expect, it } from "vitest";
import type { Cell, LayerInfo } from "../../net/protocol";
import { cellSentence, glance, momentSign, outcomeLines, writtenText } from "./celltext";

const outcome = { condition: "", weight: null, blend: 0.25, restart: false, action: null };

describe("momentSign", () => {
  it.each([["now", ""], ["end", "⇥"], ["marker left-down", "⟂ left-down"], ["window 0.2..0.6", "◫ .2–.6"]])("%s: %s", (when, sign) => {
    expect(momentSign(when)).toBe(sign);
  });
});

describe("glance", () => {
  it.each<[Cell | null, string, string[]]>([
    [null, "", []],
    [{ to: null }, "–", []],
    [{ to: "WALK", when: "now" }, "WALK", []],
    [{ to: "TLFT", when: "end", restart: true }, "TLFT!", ["⇥"]],
    [{ to: "JUMP", enter: "match", action: "jump" }, "JUMP", ["≈", "◆"]],
  ])("%j", (cell, to, signs) => expect(glance(cell)).toEqual({ to, others: 0, signs }));

  it("counts alternatives", () => {
    const alternatives = ["JUMP", "FLY"].map((to) => ({ ...outcome, to }));
    expect(glance({ to: "JUMP", alternatives }).others).toBe(2);
  });
});

describe("outcomeLines", () => {
  it("gives weights as chances", () => {
    const alternatives = [{ ...outcome, to: "STAT", weight: 3 }, { ...outcome, to: "CSTP", weight: 1 }];
    expect(outcomeLines({ to: "STAT", alternatives })).toEqual(["STAT 75 %, blend 0.25 s", "CSTP 25 %, blend 0.25 s"]);
  });

  it("gives conditions as they are written", () => {
    const alternatives = [{ ...outcome, to: "JUMP", condition: "stamina > 10" }, { ...outcome, to: "STUP" }];
    expect(outcomeLines({ to: "JUMP", alternatives })).toEqual(["JUMP if stamina > 10, blend 0.25 s", "STUP otherwise, blend 0.25 s"]);
  });
});

describe("cellSentence", () => {
  it("says where a default comes from", () => {
    expect(cellSentence("WALK", "HIT", { to: "FALL", when: "now", blend: 0.1, source: "column default", written: ["*", "HIT"] })).toBe(
      "WALK, HIT → FALL: at once, blend 0.10 s, from column default */HIT",
    );
  });
});

describe("writtenText", () => {
  const layer = {
    rows: [["state", "LEFT"], ["WALK", "TLFT! at end"]],
    table: {
      "DOWN.CRCH": { LEFT: { to: "DOWN.STUP", restart: true, when: "marker low", source: "cell" }, HIT: { to: "FALL", source: "column default" }, OFF: { to: null, source: "cell" } },
    },
  } as unknown as LayerInfo;

  it.each([
    ["WALK", "LEFT", "TLFT! at end"],
    ["DOWN.CRCH", "LEFT", "DOWN.STUP! at low"],
    ["DOWN.CRCH", "HIT", ""],
    ["DOWN.CRCH", "OFF", "-"],
    ["WALK", "HIT", ""],
  ])("%s/%s: %s", (state, event, text) => expect(writtenText(layer, state, event)).toBe(text));
});
