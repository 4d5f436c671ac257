import { expect, test } from "vitest";
import { spansOf, spansText } from "./contactTexts";

test("spans are read as they are written", () => {
  expect(spansText([[0, 0.6], [0.9, 1.1234]])).toBe("0–0.6, 0.9–1.123"); // prettier-ignore
  expect(spansOf("0–0.6, 0.9–1.123")).toEqual([[0, 0.6], [0.9, 1.123]]); // prettier-ignore
});

test.each(["0-0.6", "0 to 0.6", " 0 … 0.6 "])("%s is a span", (text) =>
  expect(spansOf(text)).toEqual([[0, 0.6]]),
);

test("a foot may never stand, or as found", () => {
  expect(spansText([])).toBe("never");
  expect(spansOf("never")).toEqual([]);
  expect(spansOf("  ")).toBeNull();
});

test.each(["0.6", "0.6–0.2", "0–1.2", "1.2–1.4", "a–b", "0–0.6,"])("%s is refused with an example", (text) =>
  expect(() => spansOf(text)).toThrow("0–0.6, 0.9–1.1"),
);
