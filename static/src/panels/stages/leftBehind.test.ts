// @vitest-environment happy-dom
import { html } from "lit-html";
import { expect, it, vi } from "vitest";
import { stageInfo } from "../../net/types/examples";
import { draw } from "../../ui/draw";
import { exampleApp } from "../../view/exampleApp";
import { leftBehind, leftBehindPart } from "./leftBehind";

const asleep = (id: string, members = {}) => stageInfo({ id, asleep: true, machines: ["hand"], ...members });
const left = [asleep("a", { inputs: 3 }), asleep("b", { inputs: 1 })];

it("counts stages that sleep, without those with a name, with a fork, and the watched one", () => {
  const fork = asleep("fork", { origin: { stage: "forked", tick: 5, is_there: true } });
  const others = [
    stageInfo({ id: "main" }),
    asleep("named", { name: "mine" }),
    asleep("forked"),
    asleep("watched"),
  ];
  const found = leftBehind([...others, fork, ...left], "watched");
  expect(found.map(({ id }) => id)).toEqual(["fork", "a", "b"]);
});

function shown() {
  const app = exampleApp();
  const discard = vi.spyOn(app.stages, "discard").mockResolvedValue();
  app.stageList.all.value = [stageInfo({ id: "main" }), ...left];
  const host = document.createElement("div");
  const part = leftBehindPart(app, async (request) => {
    await request;
  });
  document.body.append(host);
  draw(host, () => html`${part()}`);
  const press = (words: string): void =>
    [...host.querySelectorAll("button")].find((button) => button.textContent.trim() === words)!.click();
  return { app, host, discard, press };
}

it("deletes them after a yes, and says before what goes", () => {
  const { host, discard, press } = shown();
  press("delete them …");
  expect(host.textContent).toContain("Delete hand, hand for good, with 4 inputs?");
  press("delete them");
  expect(discard.mock.calls).toEqual([
    ["a", "main"],
    ["b", "main"],
  ]);
});

it("keeps them after a no", () => {
  const { host, discard, press } = shown();
  press("delete them …");
  press("keep them");
  expect(host.textContent).not.toContain("for good");
  expect(discard).not.toHaveBeenCalled();
});

it("deletes no stage that fell asleep after the question", () => {
  const { app, discard, press } = shown();
  press("delete them …");
  app.stageList.all.value = [...app.stageList.all.value, asleep("later")];
  press("delete them");
  expect(discard.mock.calls.map(([id]) => id)).toEqual(["a", "b"]);
});
