import { expect, it } from "vitest";
import { matching } from "./matching";

const ITEMS = ["ROUNDED", "RUN", "OVERRUN", "WALK", "long run"].map((name) => ({ name, note: "state" }));
const names = (typed: string): string[] => matching(ITEMS, typed).map(({ name }) => name);

it.each([
  ["run", ["RUN", "long run", "OVERRUN", "ROUNDED"]],
  ["wk", ["WALK"]],
  ["kw", []],
  ["walk state", ["WALK"]],
])("%s", (typed, expected) => expect(names(typed)).toEqual(expected));

it("nothing typed keeps the order", () => expect(names("")).toEqual(ITEMS.map(({ name }) => name)));

it("a word beside the name comes before letters that are scattered in another name", () => {
  const items = [
    { name: "senses: events that a condition or a touch raises", note: "" },
    { name: "CROUCH", note: "event: send" },
  ];
  expect(matching(items, "crouch event").map(({ name }) => name)).toEqual(["CROUCH", items[0]!.name]);
});
