import { describe, expect, it } from "vitest";
import { state } from "../../net/types/examples";
import { completions, targets } from "./completion";

const names = ["WALK", "WAVE", "STAT"];

describe("completions", () => {
  it("begins with what begins alike", () => expect(completions("wa", names, [])).toEqual(["WALK", "WAVE"]));

  it("knows what is within a name", () => expect(completions("AT", names, [])).toEqual(["STAT"]));

  it("offers all where nothing is typed", () => expect(completions("", names, [])).toEqual([...names, "-"]));

  it("goes on with the moment", () => {
    expect(completions("STAT at l", names, ["left-down"])).toEqual(["STAT at left-down"]);
  });

  it("offers a restart after a whole name", () =>
    expect(completions("WALK", names, [])).toEqual(["WALK!", "WALK at end", "WALK! at end"]));

  it("is silent where all is said", () => expect(completions("WALK at end", names, [])).toEqual([]));
});

describe("targets", () => {
  const states = [
    { name: "STAT" },
    { name: "DOWN.CRCH", outer: "DOWN" },
    { name: "DOWN.STUP", outer: "DOWN" },
  ].map(state);

  it("names siblings shortly", () =>
    expect(targets({ states }, "DOWN.CRCH").slice(0, 2)).toEqual(["CRCH", "STUP"]));

  it("names a sub-machine, and its states in full, from outside", () => {
    expect(targets({ states }, "STAT")).toEqual(["STAT", "DOWN", "DOWN.CRCH", "DOWN.STUP"]);
  });
});
