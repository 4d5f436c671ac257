import { expect, it } from "vitest";
import { detailWords } from "./detailControls";

it("the full skin is off by nothing", () => {
  expect(detailWords(11118, 0)).toBe("11,118 triangles");
  expect(detailWords(4079, 0.00748)).toBe("4,079 triangles, off by 7.5 mm");
});
