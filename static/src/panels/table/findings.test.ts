import { describe, expect, it } from "vitest";
import type { Finding } from "../../net/protocol";
import { finding as whole } from "../../net/types/examples";
import { countWords, marked, fixed } from "./findings";

const finding = (severity: Finding["severity"], message: string): Finding => whole({ severity, message });

describe("marked", () => {
  const old = finding("warning", "old");

  it("puts what is new first, whatever its weight", () => {
    expect(
      marked([old], [old, finding("info", "news")]).map(({ message, isNew }) => [message, isNew]),
    ).toEqual([
      ["news", true],
      ["old", false],
    ]);
  });

  it("knows a finding again whose message and place have changed", () => {
    const earlier = { ...finding("error", "TLFG is no state: A, B"), subject: "TLFG", state: "A" };
    const now = { ...earlier, message: "TLFG is no state: B", state: "B" };
    expect(marked([earlier], [now])[0]!.isNew).toBe(false);
    expect(fixed([earlier], [now])).toBe(0);
  });

  it("calls a property new that is no longer proved", () => {
    const proved = { ...finding("info", "A leads to B: proved"), subject: "A leads to B" };
    const refuted = { ...proved, severity: "error" as const };
    expect(marked([proved], [refuted])[0]!.isNew).toBe(true);
  });

  it("puts errors before warnings", () => {
    expect(marked([], [old, finding("error", "grave")]).map(({ message }) => message)).toEqual([
      "grave",
      "old",
    ]);
  });
});

describe("fixed", () => {
  it("counts what is gone", () =>
    expect(fixed([finding("error", "a"), finding("warning", "b")], [finding("error", "a")])).toBe(1));

  it("does not count budgets, which an edit does not measure", () =>
    expect(fixed([whole({ kind: "budget", severity: "warning" })], [])).toBe(0));
});

describe("countWords", () => {
  it.each([
    [[], "nothing is wrong"],
    [["info"], "nothing is wrong"],
    [["error", "warning", "error"], "2 errors, 1 warning"],
  ] as [Finding["severity"][], string][])("%j: %s", (severities, words) =>
    expect(countWords(severities.map((one) => finding(one, "m")))).toBe(words),
  );
});
