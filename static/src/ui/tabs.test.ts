// @vitest-environment happy-dom
import { expect, test, vi } from "vitest";
import { el } from "./dom";
import { tabs } from "./tabs";

function shown() {
  const sections = ["graph", "table", "values", "values"].map((tab, i) =>
    el("section", { id: `s${i}`, "data-tab": tab }),
  );
  const [host, panels] = [el("div"), el("div", {}, ...sections)];
  tabs(host, panels);
  const chosen = (): number[] => sections.flatMap((section, i) => (section.className ? [i] : []));
  const names = (): string[] =>
    [...host.querySelectorAll("button")]
      .filter(({ hidden }) => !hidden)
      .map(({ textContent }) => textContent);
  const click = (name: string): void =>
    [...host.querySelectorAll("button")].find(({ textContent }) => textContent === name)!.click();
  return { sections, chosen, names, click };
}

test("sections of one name have one tab, and are shown together", () => {
  const { chosen, names, click } = shown();
  expect([names(), chosen()]).toEqual([["graph", "table", "values"], [0]]);
  click("values");
  expect(chosen()).toEqual([2, 3]);
});

test("a tab without sections goes, and comes back with what was chosen", async () => {
  const { sections, chosen, names, click } = shown();
  click("values");
  for (const section of sections.slice(2)) section.hidden = true;
  await vi.waitFor(() => expect(names()).toEqual(["graph", "table"]));
  expect(chosen()).toEqual([0]);
  sections[2]!.hidden = false;
  await vi.waitFor(() => expect(chosen()).toEqual([2, 3]));
});
