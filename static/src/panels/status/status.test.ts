// @vitest-environment happy-dom
import { expect, it, test } from "vitest";
import { exampleApp } from "../../view/exampleApp";
import { linkWord, statusPanel, type Connected } from "./status";

const well: Connected = {
  link: "live",
  isSilent: false,
  status: { trouble: "", paused: false, pace: 1 },
  isLive: true,
};
const status = (part: Partial<Connected["status"]>): Connected["status"] => ({ ...well.status, ...part });

it.each<[Partial<Connected>, string]>([
  [{}, "live"],
  [{ link: "lost" }, "lost, trying again"],
  [{ link: "refused", isSilent: true }, "refused"],
  [{ isSilent: true, status: status({ trouble: "full" }) }, "no answer"],
  [{ status: status({ trouble: "full" }), isLive: false }, "not kept"],
  [{ isLive: false, status: status({ paused: true }) }, "past"],
  [{ status: status({ paused: true, pace: 0.5 }) }, "paused"],
  [{ status: status({ pace: 0.5 }) }, "slow"],
])("%j reads %s", (part, word) => expect(linkWord({ ...well, ...part })).toBe(word));

test("follows the stage, and says why", () => {
  const app = exampleApp();
  const host = document.createElement("div");
  app.session.heardAt = performance.now();
  statusPanel(host, app);
  app.line.link.value = { state: "live", detail: "" };
  expect(host.dataset["link"]).toBe("live");
  app.stage.status.value = { ...app.stage.status.value, trouble: "the disk is full" };
  const button = host.querySelector("button")!;
  expect([host.dataset["link"], button.textContent.trim(), button.title]).toEqual([
    "not kept",
    "not kept",
    "the disk is full",
  ]);
});
