// @vitest-environment happy-dom
import { expect, it, vi } from "vitest";
import * as api from "../net/api";
import { exampleApp } from "../view/exampleApp";
import type { Notice } from "./notice";

function refusedOnce() {
  const app = exampleApp();
  vi.spyOn(api, "newStage")
    .mockRejectedValueOnce(new Error("64 stages, and no more"))
    .mockResolvedValue("s2");
  const watch = vi.spyOn(app.session, "watch").mockReturnValue();
  const notices: Notice[] = [];
  app.notices.on((notice) => notices.push(notice));
  return { app, watch, notices };
}

it("watches main, and says why, if the server refuses the stage that the address names", async () => {
  const { app, watch, notices } = refusedOnce();
  await app.stages.begin(null, { machine: "hand" });
  expect(watch.mock.calls).toEqual([["main"]]);
  expect(notices).toMatchObject([{ text: "64 stages, and no more", words: "try again" }]);
});

it("opens the stage when it is tried again", async () => {
  const { app, watch, notices } = refusedOnce();
  await app.stages.begin(null, { machine: "hand" });
  (notices[0] as Exclude<Notice, string>).act();
  await vi.waitFor(() => expect(watch.mock.calls).toEqual([["main"], ["s2"]]));
});
