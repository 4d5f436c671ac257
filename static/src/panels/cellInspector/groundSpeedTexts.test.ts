import { expect, test } from "vitest";
import { groundSpeedOf, groundSpeedText } from "./groundSpeedTexts";

test.each([
  ["1.4", 1.4, [0, 1.4]],
  ["0.5, -2", [0.5, -2], [0.5, -2]],
  ["found", "found", "found"],
  ["", null, null],
] as const)("%j is a ground speed", (text, sent, shown) => {
  expect(groundSpeedOf(` ${text} `)).toEqual(sent);
  expect(groundSpeedText(shown as Parameters<typeof groundSpeedText>[0])).toBe(text);
});

test.each(["fast", "1, fast", "1, 2, 3"])("%s is refused", (text) => {
  expect(() => groundSpeedOf(text)).toThrow(/number|forward/);
});
