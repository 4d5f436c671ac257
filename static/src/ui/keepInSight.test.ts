// @vitest-environment happy-dom
import { beforeEach, expect, test, vi } from "vitest";
import { el } from "./dom";
import { keepInSight } from "./keepInSight";

const host = document.body.appendChild(el("div"));
const said = el("p", { class: "field-error", hidden: "" });
const input = el("input");
const field = el("div", { class: "field" }, input, said);
const scroll = vi.fn();
field.scrollIntoView = scroll;
host.append(field);
keepInSight(host);

const changed = (): Promise<void> => new Promise((done) => setTimeout(done));

beforeEach(() => {
  input.focus();
  scroll.mockClear();
});

test("follows what is said of the focused field", async () => {
  said.textContent = "no state is called WLK";
  await changed();
  expect(scroll).toHaveBeenCalledOnce();
});

test("follows the focused field when an entry comes before it", async () => {
  host.prepend(el("fieldset"));
  await changed();
  expect(scroll).toHaveBeenCalledOnce();
});

test.each([
  ["another part changes", () => host.append(el("p"))],
  ["the focus is elsewhere", () => (input.blur(), (said.textContent = "again"))],
])("leaves the form where it is if %s", async (_, change) => {
  change();
  await changed();
  expect(scroll).not.toHaveBeenCalled();
});
