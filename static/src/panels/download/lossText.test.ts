import { expect, test } from "vitest";
import { lossText } from "./lossText";

test("a format that holds everything says so", () => {
  expect(lossText([])).toBe("holds everything");
});

test("what is lost is counted, what has a substitute says which", () => {
  const lost = [
    { part: "skins", count: 2, instead: "" },
    { part: "meshes", count: 1, instead: "" },
    { part: "stepped keys", count: 3, instead: "as frames" },
  ];
  expect(lossText(lost)).toBe("cannot hold skins (2), meshes (1); stepped keys: as frames");
  expect(lossText(lost.slice(2))).toBe("stepped keys: as frames");
});
