import { describe, expect, it } from "vitest";
import { keyBinding } from "../net/types/examples";
import { changedBy, changedIn, KeyChanges, ratesOf } from "./keyChanges";
import type { ParameterValues } from "./parameterValues";

const left = keyBinding({ change: { TIP: { bend: -40 }, REACH: { "aim.x": -1, bend: 2 } } });
const any = keyBinding({ change: { TIP: { bend: -40 }, "*": { pace: 1 } } });

describe("keys that change parameters", () => {
  it.each([
    [left, ["REACH", "OFF"], { "aim.x": -1, bend: 2 }],
    [left, ["REACH", "TIP"], { bend: -40 }],
    [left, ["SWAY", "OFF"], {}],
    [any, ["SWAY", "OFF"], { pace: 1 }],
    [keyBinding({ press: "GO" }), ["REACH"], {}],
  ])("change what the first state says", (key, states, rates) => expect(ratesOf(key, states)).toEqual(rates));

  it("name their parameters", () => {
    expect(changedBy(left)).toEqual(["bend", "aim.x"]);
    expect(changedIn({ left }, "aim.x", ["REACH"])).toBe(true);
    expect(changedIn({ left }, "aim.x", ["SWAY"])).toBe(false);
    expect(changedIn({ left }, "pace", ["SWAY"])).toBe(true); // no key changes it
  });

  it("move them as long as they are down", () => {
    const values = new Map([["bend", 10]]);
    const changes = new KeyChanges(
      {
        get: (name: string) => values.get(name)!,
        set: (name: string, value: number) => values.set(name, value),
      } as unknown as ParameterValues,
      () => ["TIP"],
    );
    changes.advance(1);
    expect(changes.press("ArrowLeft", left)).toBe(true);
    expect(changes.press("a", keyBinding({ press: "GO" }))).toBe(false);
    changes.advance(0.5);
    expect(values.get("bend")).toBe(-10);
    changes.release("ArrowLeft");
    changes.advance(0.5);
    expect(values.get("bend")).toBe(-10);
  });
});
