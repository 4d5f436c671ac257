import { expect, test } from "vitest";
import { freeName } from "./machineMenu";

test("a free name counts on", () => {
  expect(freeName("walker", ["other"])).toBe("walker");
  expect(freeName("walker", ["walker"])).toBe("walker-2");
  expect(freeName("walker-2", ["walker-2", "walker-3"])).toBe("walker-4");
});
