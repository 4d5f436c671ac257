import { expect, test } from "vitest";
import type { ActorView, ExpressionView } from "../../net/types/api.generated";
import { fault, lineSpan, rounded, sides, valueOf } from "./lines";

test("a line has a name and a formula", () => {
  expect(sides("a.rotate_z = if(x == 1, 2, 3)")).toEqual(["a.rotate_z", "if(x == 1, 2, 3)"]);
});

test("values have at most four digits after the point", () => {
  expect(rounded(Math.PI)).toBe("3.1416");
  expect(rounded(8)).toBe("8");
});

test("a line shows the value of its channel or variable", () => {
  const facts = { channels: { "a.rotate_z": 20 }, variables: { half: 0.5 } } as unknown as ActorView;
  const line = (name: string): ExpressionView => ({ line: 1, name, formula: "", source: "machine" });
  expect(valueOf(line("a.rotate_z"), facts)).toBe("20");
  expect(valueOf(line("half"), facts)).toBe("0.5");
  expect(valueOf(line("other"), facts)).toBe("");
  expect(valueOf(line("half"), null)).toBe("");
});

test("a fault names the line of the edited text", () => {
  const file = "initial: A\ntable: |\n  state\nexpressions: |\n  a = 1\n  b = 2\n";
  expect(fault("machine.yaml, line 6: no variable is called 'x'", file)).toEqual({
    line: 2,
    words: "line 2: no variable is called 'x'",
  });
  const none = "initial: A\ntable: |\n  state\n";
  expect(fault("line 5: wrong", none)).toEqual({ line: 1, words: "line 1: wrong" });
  expect(fault("the machine is gone", file)).toEqual({ line: 0, words: "the machine is gone" });
});

test("a line of a text has a beginning and an end", () => {
  expect(lineSpan("ab\n\ncde", 3)).toEqual([4, 7]);
  expect(lineSpan("ab\n\ncde", 2)).toEqual([3, 3]);
  expect(lineSpan("ab", 0)).toBeNull();
  expect(lineSpan("ab", 2)).toBeNull();
});
