// @vitest-environment happy-dom
import { signal } from "@preact/signals-core";
import { expect, test } from "vitest";
import { hiddenNote } from "./hiddenNote";

test("a character of which nothing is drawn is told, and comes back", () => {
  const modes = signal({ skin: false, wire: false, bones: true, tetra: false, limits: true });
  const note = hiddenNote({ modes });
  expect(note.hidden).toBe(true);
  modes.value = { ...modes.value, bones: false };
  expect(note.hidden).toBe(false);
  note.querySelector("button")!.click();
  expect([note.hidden, modes.value.skin]).toEqual([true, true]);
});
