// @vitest-environment happy-dom
import { expect, test, vi } from "vitest";
import { layer, state } from "../../net/types/examples";
import { exampleApp, watch } from "../../view/exampleApp";
import { expressionsPanel } from "./expressions";

const lines = [{ line: 7, name: "a", formula: "b * 2", source: "machine" as const }];
const layers = [layer({ states: [state({ name: "A", expressions: ["c = 1"] })] })];

function shown() {
  const app = exampleApp();
  const host = document.createElement("section");
  document.body.append(host);
  expressionsPanel(host, app);
  watch(app, {
    expressions: lines,
    expression_text: "a = b * 2",
    layers,
    text: "expressions:\n  - a = b * 2\n",
  });
  const button = (name: string): HTMLButtonElement =>
    [...host.querySelectorAll("button")].find(({ textContent }) => textContent === name)!;
  return { app, host, button, field: host.querySelector("textarea")!, form: host.querySelector("form")! };
}

test("lists the lines of the machine, and those of the present states", () => {
  const { app, host } = shown();
  const rows = (): string[] =>
    [...host.querySelectorAll("li")].map((row) => row.textContent.replace(/\s+/g, " ").trim());
  expect(rows()).toEqual(["7 a b * 2"]);
  app.selection.tellStates(["A"]);
  expect(rows()).toEqual(["7 a b * 2", "cA 1"]);
});

test("a text that is kept closes the form", async () => {
  const { app, button, field, form } = shown();
  button("edit").click();
  expect([form.hidden, field.value]).toEqual([false, "a = b * 2"]);
  const keep = vi.spyOn(app.editing, "keep").mockResolvedValue({ kind: "fine", words: "", findings: [] });
  field.value = "a = 3";
  form.dispatchEvent(new Event("submit"));
  await vi.waitFor(() => expect(form.hidden).toBe(true));
  expect(keep).toHaveBeenCalledWith([{ kind: "set_expressions", text: "a = 3" }]);
});

test("a text that is refused stays, with its line selected", async () => {
  const { app, host, button, field, form } = shown();
  button("edit").click();
  const words = "machine.yaml, line 2: no variable is called 'x'";
  vi.spyOn(app.editing, "keep").mockResolvedValue({ kind: "refused", words, findings: [] });
  field.value = "a = x";
  form.dispatchEvent(new Event("submit"));
  await vi.waitFor(() => expect(host.querySelector(".refused")!.textContent).not.toBe(""));
  expect([form.hidden, field.value, field.selectionStart, field.selectionEnd]).toEqual([
    false,
    "a = x",
    0,
    5,
  ]);
});
