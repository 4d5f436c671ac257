// @vitest-environment happy-dom
import { beforeEach, expect, it } from "vitest";
import { keyBinding } from "../../net/types/examples";
import { el } from "../../ui/dom";
import { exampleApp, watch } from "../../view/exampleApp";
import type { App } from "../../view/app";
import { helpPanel } from "./help";

const find = (selector: string): HTMLElement => document.querySelector<HTMLElement>(selector)!;
const keyOf = (words: string): HTMLElement => find(`.key[aria-label^="key of “${words}”"]`);

function press(key: string): void {
  find("dialog").dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true }));
}

function opened(): App {
  const [app, host] = [exampleApp(), el("button")];
  app.commands.add({ words: "frame", keys: ["f"], act: () => {} });
  watch(app, { title: "Walker", keys: { j: keyBinding({ press: "JUMP" }) } });
  helpPanel(host, app);
  host.click();
  keyOf("frame").click();
  return app;
}

beforeEach(() => {
  localStorage.clear();
  document.body.replaceChildren();
});

it("a click and a key give a command this key", () => {
  const app = opened();
  press("q");
  expect([app.commands.of("q")?.words, keyOf("frame").textContent]).toEqual(["frame", "Q"]);
});

it.each([
  ["?", "? is already the key of “this help”"],
  ["j", "J is a key of Walker"],
])("a conflict is told: %s", (key, told) => {
  const app = opened();
  press(key);
  expect([find(".told").textContent, app.commands.of("f")?.words]).toEqual([told, "frame"]);
});

it("reset is offered after a change", () => {
  const app = opened();
  expect(find(".reset").hidden).toBe(true);
  press("q");
  find(".reset").click();
  expect(app.commands.of("f")?.words).toBe("frame");
});
