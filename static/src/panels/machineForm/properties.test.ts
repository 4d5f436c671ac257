import { expect, it, test } from "vitest";
import { finding } from "../../net/types/examples";
import { verdictOf } from "./properties";

const says = (message: string) => finding({ kind: "property", message });
const FINDINGS = [
  says("JUMP only after WALK: proved"),
  says("JUMP only after: not understood: a property reads A only after B"),
  says("never WALK -> JUMP: refuted: STAT -FORWARD 1 s-> WALK"),
  finding({ kind: "dead-cell", message: "WALK leads to STAT within 1 s: proved" }),
];

it.each([
  ["JUMP only after WALK", "proved", "proved"],
  ["never WALK -> JUMP", "refuted", "refuted: STAT -FORWARD 1 s-> WALK"],
  ["JUMP only after", "not understood", "not understood: a property reads A only after B"],
])("%s is %s", (text, kind, words) => expect(verdictOf(text, FINDINGS)).toMatchObject({ kind, words }));

test("other findings are no verdict", () =>
  expect(verdictOf("WALK leads to STAT within 1 s", FINDINGS)).toBeNull());
