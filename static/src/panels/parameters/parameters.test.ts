// @vitest-environment happy-dom
import { describe, expect, it, test } from "vitest";
import { keyBinding, parameter } from "../../net/types/examples";
import { exampleApp, watch } from "../../view/exampleApp";
import { parametersPanel, short } from "./parameters";

describe("a parameter's value", () => {
  it.each([
    [0, "0"],
    [1.23456, "1.23"],
    [2, "2"],
    [-0.00051234, "-0.000512"],
    [1234.5, "1230"],
  ])("%d reads %s", (value, text) => expect(short(value)).toBe(text));
});

const parameters = [
  parameter({ name: "pace", maximum: 2, default: 1 }),
  parameter({ name: "bend", maximum: 90, default: 30 }),
  parameter({ name: "speed", driven: true }),
];
const keys = { a: keyBinding({ change: { TIP: { bend: 40 } } }) };

const labelOf = (element: Element): string | null => element.getAttribute("aria-label");

function shown() {
  const app = exampleApp();
  const host = document.createElement("section");
  parametersPanel(host, app);
  const sliders = (): HTMLInputElement[] => [...host.querySelectorAll("input")];
  return { app, host, sliders };
}

test("each parameter that nothing else moves has a slider at its value", () => {
  const { app, host, sliders } = shown();
  expect(host.hidden).toBe(true);
  watch(app, { parameters });
  expect(host.hidden).toBe(false);
  expect(sliders().map((slider) => [labelOf(slider), slider.value])).toEqual([
    ["pace", "1"],
    ["bend", "30"],
  ]);
});

test("a slider sets its parameter, and follows it", () => {
  const { app, host, sliders } = shown();
  watch(app, { parameters });
  const [pace] = sliders();
  pace!.value = "1.5";
  pace!.dispatchEvent(new Event("input"));
  expect(app.parameters.get("pace")).toBe(1.5);
  app.parameters.set("pace", 0.25);
  expect([pace!.value, host.querySelector("output")!.textContent]).toEqual(["0.25", "0.25"]);
});

test("the slider of a parameter that keys change shows in their states", () => {
  const { app, sliders } = shown();
  watch(app, { parameters, keys });
  expect(sliders().map(labelOf)).toEqual(["pace"]);
  app.selection.tellStates(["TIP"]);
  expect(sliders().map(labelOf)).toEqual(["pace", "bend"]);
});
