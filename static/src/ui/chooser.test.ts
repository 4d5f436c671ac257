// @vitest-environment happy-dom
import { afterEach, expect, it } from "vitest";
import { find } from "./chooser";
import type { Named } from "./matching";

const named = (...names: string[]): Named[] => names.map((name) => ({ name, note: "" }));
const shown = (): (string | null)[] =>
  [...document.querySelectorAll("#choices li span")].map(({ textContent }) => textContent);
const press = (key: string): void => {
  document.querySelector("dialog")!.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true }));
};
const never = new Promise<Named[]>(() => undefined);

afterEach(() => document.body.replaceChildren());

it("opens before newer items are known: typed letters are its own", () => {
  void find("find", named("main"), never);
  expect(document.activeElement).toBe(document.querySelector("dialog input"));
});

it("shows newer items when they are known", async () => {
  const newer = Promise.resolve(named("main", "Idea B"));
  void find("find", named("main"), newer);
  await newer;
  expect(shown()).toEqual(["main", "Idea B"]);
});

it("keeps the marked item marked among newer ones", async () => {
  const newer = Promise.resolve(named("Idea B", "main", "walk"));
  const found = find("find", named("main", "walk"), newer);
  press("ArrowDown");
  await newer;
  press("Enter");
  expect((await found)?.name).toBe("walk");
});
