// @vitest-environment happy-dom
import { render } from "lit-html";
import { expect, test } from "vitest";
import type { Operation } from "../../net/protocol";
import type { Editing } from "../../state/editing";
import { EditingFields } from "../../state/editingFields";
import { markerFields } from "./markerFields";

const MOVE = { state: "MOVE", layer: "base" };
const LEFT = { name: "left", phase: 0.25, written: true };
const OWN = { name: "own", phase: 0.5, written: false };

/** Draws the markers of a clip; returns their fields by label, and the operations that are kept. */
function drawn(clip: string) {
  const kept: Operation[] = [];
  const keep = (operations: readonly Operation[]) => {
    kept.push(...operations);
    return Promise.resolve({ kind: "fine", words: "", findings: [] });
  };
  const host = document.createElement("div");
  render(markerFields(new EditingFields({ keep } as unknown as Editing), MOVE, clip, [LEFT, OWN]), host);
  const fields = [...host.querySelectorAll(".field")].map(
    (field) => [field.querySelector("label")!.textContent, field.querySelector("input")!] as const,
  );
  return { fields: new Map(fields), kept };
}

function type(input: HTMLInputElement | undefined, text: string): void {
  input!.value = text;
  input!.dispatchEvent(new Event("change"));
}

test("a marker that the machine does not write has its phase alone", () =>
  expect([...drawn("walk").fields.keys()]).toEqual(["marker", "phase", "own", "new"]));

test("a marker of a clip is moved, deleted, added and renamed", () => {
  const { fields, kept } = drawn("walk");
  type(fields.get("phase"), "0.3");
  type(fields.get("phase"), "");
  type(fields.get("new"), "right 0.75");
  type(fields.get("marker"), "left-down");
  const set = { kind: "set_marker", ...MOVE, clip: "walk" };
  expect(kept).toEqual([
    { ...set, marker: "left", phase: 0.3 },
    { ...set, marker: "left", phase: null },
    { ...set, marker: "right", phase: 0.75 },
    { kind: "rename_event", event: "left", to: "left-down" },
  ]);
});

test("a marker of a state names no clip", () => {
  const { fields, kept } = drawn("");
  type(fields.get("own"), "0.6");
  expect(kept).toEqual([{ kind: "set_marker", ...MOVE, marker: "own", phase: 0.6 }]);
});
