// @vitest-environment happy-dom
import { expect, test, vi } from "vitest";
import { finding } from "../../net/types/examples";
import { exampleApp, watch } from "../../view/exampleApp";
import { versionBar } from "./versionBar";

function shown() {
  const app = exampleApp();
  const host = document.createElement("div");
  versionBar(host, app, () => undefined);
  const button = (name: string): HTMLButtonElement => host.querySelector(`button.${name}`)!;
  return { app, host, button };
}

test("shows the version, and what can be undone and redone", () => {
  const { app, host, button } = shown();
  watch(app, { version: 3, undo: 1, redo: 0 });
  expect(host.querySelector(".version")!.textContent).toBe("v3");
  expect([button("undo").disabled, button("redo").disabled]).toEqual([false, true]);
});

test("counts the findings", () => {
  const { app, button } = shown();
  expect(button("count").textContent).toBe("…");
  app.editing.verified.value = [];
  expect(button("count").textContent).toBe("✓");
  app.editing.verified.value = [finding({ severity: "error" })];
  expect([button("count").textContent, button("count").getAttribute("aria-label")]).toEqual([
    "1 error",
    "findings: 1 error",
  ]);
});

test("Ctrl+Z undoes if there is something to undo", () => {
  const { app } = shown();
  const undo = vi.spyOn(app.editing, "undo").mockResolvedValue();
  const press = (): boolean =>
    window.dispatchEvent(new KeyboardEvent("keydown", { key: "z", ctrlKey: true }));
  watch(app, { version: 1, undo: 0 });
  press();
  expect(undo).not.toHaveBeenCalled();
  watch(app, { version: 2, undo: 1 });
  press();
  expect(undo).toHaveBeenCalledOnce();
});
