// @vitest-environment happy-dom
import { expect, test } from "vitest";
import { machine } from "../../net/types/examples";
import { exampleApp } from "../../view/exampleApp";
import { versionsPanel } from "./versions";

test("shows the newest versions, and the older ones on demand, until another machine is watched", () => {
  const app = exampleApp();
  const host = document.createElement("div");
  versionsPanel(host, app);
  app.editing.versions.value = Array.from({ length: 60 }, (_, k) => ({
    version: k + 1,
    what: "edited",
    at: k,
    author: "",
    ...{ before: 0, after: 0 },
  }));
  const rows = (): (string | null)[] => [...host.querySelectorAll("li b")].map((each) => each.textContent);
  expect([rows().length, rows()[0], rows().at(-1)]).toEqual([50, "v60", "v11"]);

  const older = (): HTMLElement | null => host.querySelector(".older");
  expect(older()!.textContent.trim()).toBe("10 older");
  older()!.click();
  expect([rows().length, rows().at(-1), older()]).toEqual([60, "v1", null]);

  app.machine.info.value = machine({ name: "another" });
  expect(rows().length).toBe(50);
});
