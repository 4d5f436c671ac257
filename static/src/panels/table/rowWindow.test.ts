import { describe, expect, it } from "vitest";
import { drawnLines, gaps } from "./rowWindow";

describe("the lines that are drawn", () => {
  const sight = { top: 2700, height: 270, line: 27 };
  it("are those in sight and ten on each side", () => {
    const lines = drawnLines(300, sight, []);
    expect([lines[0], lines.at(-1)]).toEqual([90, 120]);
  });
  it("are also those that stay", () => expect(drawnLines(300, sight, [7, -1])[0]).toBe(7));
  it("are all of a small table", () => expect(drawnLines(60, sight, [])).toHaveLength(60));
});

it("rooms are left for the others", () => expect(gaps(300, [7, 90, 91])).toEqual([7, 82, 0, 208]));
