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
