// @vitest-environment happy-dom
import { expect, test, vi } from "vitest";
import type { Finding } from "../../net/protocol";
import { cell, finding } from "../../net/types/examples";
import { exampleApp } from "../../view/exampleApp";
import { TrialReport, fineWords } from "./trialReport";

const old = finding({ severity: "warning", message: "old" });
const news = finding({ severity: "error", message: "news", state: "A", event: "GO" });

function shown() {
  const app = exampleApp();
  const host = document.createElement("div");
  const gone: Finding[] = [];
  const inspector = new TrialReport(host, app.editing, (one) => gone.push(one), vi.fn());
  app.editing.verified.value = [old];
  const items = (): string[] =>
    [...host.querySelectorAll(".findings li")].map((item) => item.textContent.replace(/\s+/g, " ").trim());
  const words = (): string => host.querySelector(".trial")!.textContent;
  return { app, host, inspector, items, words, gone };
}

test("says what a text changes", () => {
  expect(fineWords([old], [old])).toBe("Enter keeps it, Escape drops it: nothing new is wrong.");
  expect(fineWords([old], [news])).toBe("Enter keeps it, Escape drops it (1 new below, 1 fixed).");
});

test("shows the findings about the table on demand, and follows them", () => {
  const { app, host, inspector, items, words } = shown();
  expect(host.hidden).toBe(true);
  inspector.toggle();
  expect([host.hidden, words(), items()]).toEqual([false, "1 warning", ["warning: old"]]);
  app.editing.verified.value = [];
  expect([words(), items()]).toEqual(["nothing is wrong", []]);
});

test("calls nothing new, and nothing right, before the verifier has answered", () => {
  const { app, inspector, items, words } = shown();
  app.editing.verified.value = null;
  inspector.toggle();
  expect(words()).toBe("not known yet");
  inspector.begin("A", "GO", cell({ to: "B" }));
  inspector.show({ kind: "fine", words: "", findings: [news] });
  expect([words(), items()]).toEqual(["Enter keeps it, Escape drops it.", ["error: news A/GO"]]);
});

test("a refused text shows its reasons, which lead to their cells", () => {
  const { host, inspector, items, words, gone } = shown();
  inspector.begin("A", "GO", cell({ to: "B" }));
  inspector.show({ kind: "refused", words: "no", findings: [news] });
  expect([host.dataset["trial"], words()]).toEqual(["refused", "Refused: you cannot keep this text."]);
  expect(items()).toEqual(["new error: news A/GO"]);
  host.querySelector<HTMLButtonElement>("button.where")!.click();
  expect(gone).toMatchObject([news]);
});

test("a refusal without findings shows the server's words", () => {
  const { inspector, items } = shown();
  inspector.begin("A", "GO", undefined);
  inspector.show({ kind: "refused", words: "no such state", findings: [] });
  expect(items()).toEqual(["new error: no such state"]);
});

test("another editor's edit stays told until the editor is closed", () => {
  const { host, inspector, words } = shown();
  inspector.begin("A", "GO", undefined);
  inspector.show({ kind: "stale", words: "v2 is newer", findings: [] });
  inspector.show({ kind: "fine", words: "", findings: [old] });
  expect(words()).toMatch(/^Another editor was faster: v2 is newer.*Enter keeps it, Escape drops it/);
  inspector.end();
  expect(host.hidden).toBe(true);
});
