import { describe, expect, it } from "vitest";
import { short } from "./parameters";

describe("a parameter's value", () => {
  it.each([
    [0, "0"],
    [1.23456, "1.23"],
    [2, "2"],
    [-0.00051234, "-0.000512"],
    [1234.5, "1230"],
  ])("%d reads %s", (value, text) => expect(short(value)).toBe(text));
});
