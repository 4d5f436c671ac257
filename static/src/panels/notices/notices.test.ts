// @vitest-environment happy-dom
import { expect, test } from "vitest";
import { Event } from "../../state/event";
import type { Notice } from "../../state/notice";
import type { App } from "../../view/app";
import { noticesPanel } from "./notices";

function shown(...said: Notice[]): string[] {
  const [host, notices] = [document.createElement("div"), new Event<Notice>()];
  noticesPanel(host, { notices } as unknown as App);
  for (const notice of said) notices.emit(notice);
  return [...host.children].map((note) => note.textContent);
}

const back: Notice = { text: "You watch a fork.", words: "back", act: () => undefined };

test("a sentence that is said again is shown once, as the newest", () => {
  expect(shown("saved", "outside", "saved")).toEqual(["outside", "saved"]);
  expect(shown(back, "saved", back)).toEqual(["saved", "You watch a fork.back"]);
});

test("the three newest are shown", () => {
  expect(shown("1", "2", "3", "4")).toEqual(["2", "3", "4"]);
});
