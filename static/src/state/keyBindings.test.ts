import { describe, expect, it } from "vitest";
import { keyBinding } from "../net/types/examples";
import { HeldKeys, type Intent, bindingOf, cap, mainEvent } from "./keyBindings";

function held(): { keys: HeldKeys; said: string[] } {
  const said: string[] = [];
  return {
    keys: new HeldKeys(
      () =>
        ({ kind, event }: Intent) =>
          said.push(`${kind} ${event}`),
    ),
    said,
  };
}

describe("HeldKeys", () => {
  it("presses going down and presses the release event coming up", () => {
    const { keys, said } = held();
    keys.press("ArrowUp", keyBinding({ press: "FORWARD", release: "STOP" }));
    keys.release("ArrowUp");
    expect(said).toEqual(["press FORWARD", "press STOP"]);
  });

  it("holds what the machine wants held", () => {
    const { keys, said } = held();
    keys.press("ArrowLeft", keyBinding({ press: "LEFT", hold: true }));
    keys.release("ArrowLeft");
    expect(said).toEqual(["hold LEFT", "release LEFT"]);
  });

  it("holds what is pressed, and presses the release event", () => {
    const { keys, said } = held();
    keys.press("a", keyBinding({ press: "GO", hold: true, release: "STOP" }));
    keys.release("a");
    expect(said).toEqual(["hold GO", "release GO", "press STOP"]);
  });

  it("ignores the keyboard's repeats and a second release", () => {
    const { keys, said } = held();
    keys.press("j", keyBinding({ press: "JUMP" }));
    expect([
      keys.press("j", keyBinding({ press: "JUMP" })),
      keys.release("j"),
      keys.release("j"),
      said.length,
    ]).toEqual([false, true, false, 1]);
  });

  it("lets everything go when the page loses the keyboard", () => {
    const { keys, said } = held();
    keys.press("a", keyBinding({ press: "LEFT", hold: true }));
    keys.press("b", keyBinding({ press: "FORWARD", release: "STOP" }));
    keys.releaseAll();
    expect(said.slice(2)).toEqual(["release LEFT", "press STOP"]);
  });
});

describe("bindings", () => {
  it.each([
    ["ArrowUp", "ArrowUp", "ArrowUp"],
    [" ", "Space", "Space"],
    ["J", "KeyJ", "j"],
    ["x", "KeyX", null],
  ])("%j is found as %j", (key, code, expected) => {
    expect(bindingOf({ ArrowUp: keyBinding({}), Space: keyBinding({}), j: keyBinding({}) }, key, code)).toBe(
      expected,
    );
  });

  it("knows the event a button stands for", () => {
    expect([
      mainEvent(keyBinding({ press: "LEFT", hold: true })),
      mainEvent(keyBinding({ press: "A", release: "B" })),
      mainEvent(keyBinding({ release: "B" })),
    ]).toEqual(["LEFT", "A", null]);
  });

  it.each([
    ["ArrowUp", "↑"],
    [" ", "space"],
    ["j", "J"],
    ["KeyQ", "Q"],
  ])("%j has the cap %s", (key, expected) => expect(cap(key)).toBe(expected));
});
