// @vitest-environment happy-dom
import { render } from "lit-html";
import { expect, test } from "vitest";
import { report } from "./twins";

const pair = (left: string, alike: number) => ({
  left,
  right: left.replace("L", "R"),
  alike,
  twinned: alike >= 0.9,
  swing_deg: 20,
});

function shown(pairs: ReturnType<typeof pair>[], alone: string[] = []): HTMLElement {
  const host = document.createElement("div");
  render(report({ clip: "wave", pairs, alone }), host);
  return host;
}

test("pairs that do the same at the same moment are counted and marked", () => {
  const host = shown([pair("ArmL", 0.95), pair("LegL", -0.4)]);
  expect(host.querySelector("p")!.textContent).toBe("1 of 2 pairs does the same at the same moment");
  expect(host.querySelectorAll(".twinned").length).toBe(1);
  expect(host.querySelector("tbody tr:last-child")!.textContent.replace(/\s+/g, " ").trim()).toContain(
    "-0.40",
  );
});

test("a clip in which no pair moves says so, and joints without a partner are named", () => {
  const host = shown([], ["TailL"]);
  expect([...host.querySelectorAll("p")].map((line) => line.textContent)).toEqual([
    "no pair of left and right moves",
    "without a partner: TailL",
  ]);
});
