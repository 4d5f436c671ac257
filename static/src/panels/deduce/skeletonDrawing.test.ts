import { expect, test } from "vitest";
import type { DeducedBone } from "../../net/protocol";
import { kindOf, segments } from "./skeletonDrawing";

const bone = (sources: Record<string, string>, end: [number, number, number]): DeducedBone => ({
  name: "b",
  parent: -1,
  values: Object.fromEntries(
    Object.entries(sources).map(([name, source]) => [name, { value: [0, 0, 0], source }]),
  ),
  unknown: [],
  start: [0, 0, 0],
  end,
});

test("a bone is known, deduced or unknown by the sources of its ends", () => {
  expect(kindOf(bone({ SP: "given", EP: "given" }, [0, 1, 0]))).toBe("known");
  expect(kindOf(bone({ SP: "given", EP: "rule 7" }, [0, 1, 0]))).toBe("deduced");
  expect(kindOf(bone({ SP: "given" }, [0, 1, 0]))).toBe("unknown");
});

test("up is up, and the drawing keeps its margins", () => {
  const [segment] = segments([bone({}, [0, 2, 0])], 0, 100);
  expect(segment?.from).toEqual([50, 92]);
  expect(segment?.to).toEqual([50, 8]);
});

test("a turn by 90 degrees shows the depth", () => {
  const [segment] = segments([bone({}, [0, 0, 1])], 90, 100);
  expect(segment?.to[0]).toBeCloseTo(92);
});
