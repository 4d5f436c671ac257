// @vitest-environment happy-dom
import { expect, it } from "vitest";
import { hello } from "../../net/types/examples";
import type { App } from "../../view/app";
import { exampleApp } from "../../view/exampleApp";
import { actionCounterPanel } from "./actionCounter";

function counting(...names: string[]): { app: App; shown: () => string[] } {
  const [host, app] = [document.createElement("div"), exampleApp()];
  actionCounterPanel(host, app);
  const other = { type: "action" as const, seq: 1, tick: 1, actor: 1, arguments: [], other: 0 };
  for (const name of names) app.session.actions.emit({ ...other, name });
  return { app, shown: () => [...host.querySelectorAll("li")].map(({ textContent }) => textContent) };
}

it("counts actions by name, the latest first; raised events are none", () =>
  expect(counting("jump", "land", "jump", "raise").shown()).toEqual(["2jump", "1land"]));

it("keeps the eight latest names", () => {
  const names = ["a", "b", "c", "d", "e", "f", "g", "h", "i"];
  expect(counting(...names).shown()).toEqual(
    names
      .slice(1)
      .reverse()
      .map((name) => `1${name}`),
  );
});

it("starts from zero on another stage", () => {
  const { app, shown } = counting("jump");
  app.stage.greet(hello({ stage: "other" }));
  expect(shown()).toEqual([]);
});
