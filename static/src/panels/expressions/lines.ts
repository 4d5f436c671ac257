/** What the lines of expressions say: their sides, their values, and where one is wrong. */

import type { ActorView, ExpressionView } from "../../net/types/api.generated";

const KEY = "expressions:";

/** Splits a line at its first equals sign. */
export function sides(line: string): [string, string] {
  const at = line.indexOf("=");
  return [line.slice(0, at).trim(), line.slice(at + 1).trim()];
}

/** Writes a value with at most four digits after the point. */
export function rounded(value: number): string {
  return String(Number(value.toFixed(4)));
}

/** Returns the present value of a line: a channel's or a variable's. */
export function valueOf(line: ExpressionView, facts: ActorView | null): string {
  const value = facts?.channels[line.name] ?? facts?.variables[line.name];
  return value === undefined ? "" : rounded(value);
}

/** Says what is wrong by the line of the text that is edited, not of the machine file `file`. */
export function fault(words: string, file: string): { line: number; words: string } {
  const found = /^[^:]*\bline (\d+): (.*)/s.exec(words);
  const lines = file.trimEnd().split("\n");
  const key = lines.findIndex((line) => line.startsWith(KEY));
  const line = Number(found?.[1] ?? 0) - (key < 0 ? lines.length : key) - 1;
  if (!found || line < 1) return { line: 0, words };
  return { line, words: `line ${line}: ${found[2] ?? ""}` };
}

/** Returns where a line of a text begins and ends, from 1; null if there is none. */
export function lineSpan(text: string, line: number): [number, number] | null {
  const lines = text.split("\n");
  if (line < 1 || line > lines.length) return null;
  const start = lines.slice(0, line - 1).reduce((all, each) => all + each.length + 1, 0);
  return [start, start + lines[line - 1]!.length];
}
