import { expect, test } from "vitest";
import { read, written } from "./curvesAddress";
import { EXAMPLES } from "./keyTable";

test("what is written is read again", () => {
  for (const keys of Object.values(EXAMPLES))
    expect(read(written(keys, new Set(["b-spline through"])))).toEqual({
      keys,
      hidden: new Set(["b-spline through"]),
    });
});

test.each([
  "",
  "?key=0_0_0_0_1",
  "?key=0_0_0_0&key=1_0_0_0",
  "?key=0_0_0_0_1&key=0_0_0_0_1",
  "?key=a_0_0_0_1&key=1_0_0_0_1",
  `?${Array.from({ length: 33 }, (_, i) => `key=${i}_0_0_0_1`).join("&")}`,
])("no keys are read from %s", (query) => expect(read(query).keys).toBeNull());
