import { describe, expect, it, test } from "vitest";
import { parameter, state } from "../../net/types/examples";
import {
  along,
  axesOf,
  blendOver,
  makeBlend,
  oneClip,
  placeOf,
  putClip,
  stepped,
  valueAt,
} from "./blendSpace";

const WALK = { state: "WALK", layer: "base" };
const PACE = parameter({ name: "pace", maximum: 2 });
const [pace, turn] = axesOf(
  state({ over: ["pace", "entry turn"], points: { walk: [1, -90], run: [3, 90] } }),
  [PACE],
) as [ReturnType<typeof axesOf>[0], ReturnType<typeof axesOf>[0]];

it("an axis holds its parameter's bounds and all clips", () => {
  expect(pace).toMatchObject({ least: 0, most: 3, parameter: PACE });
  expect(turn).toMatchObject({ least: -90, most: 90, parameter: null });
});

it("a place on an axis is a value with few digits", () => {
  expect(along(turn, 45)).toBe(0.75);
  expect(valueAt(pace, 1 / 3)).toBe(1);
  expect(valueAt(turn, 0.33333)).toBe(-30);
  expect(valueAt(pace, 2)).toBe(3);
});

test.each([
  ["ArrowRight", [1.65, 0]],
  ["ArrowDown", [1.5, -9]],
  ["Enter", null],
])("%s leads to %j", (key, place) => expect(stepped([pace, turn], [1.5, 0], key)).toEqual(place));

test("a line has no up and down", () => expect(stepped([pace], [1], "ArrowUp")).toBeNull());

test("a place needs a number for each axis", () => {
  expect(placeOf("1, -2.5", [pace, turn])).toEqual([1, -2.5]);
  expect(() => placeOf("1", [pace, turn])).toThrow("two numbers");
  expect(() => placeOf("1,", [pace, turn])).toThrow("two numbers");
});

test("a clip of a line has one number, of a pad two", () => {
  expect(putClip(WALK, "run", [2])).toEqual([{ kind: "set_blend_clip", ...WALK, clip: "run", at: 2 }]);
  expect(putClip(WALK, "run", [2, 1])).toEqual([
    { kind: "set_blend_clip", ...WALK, clip: "run", at: [2, 1] },
  ]);
});

test("a blend lies between the bounds of its parameter", () =>
  expect(makeBlend(WALK, ["walk", "run"], "pace", [PACE])).toEqual([
    { kind: "set_state", ...WALK, fields: { motion: { over: "pace", clips: { walk: 0, run: 2 } } } },
  ]));

test("a blend over a new name makes the parameter too", () =>
  expect(makeBlend(WALK, ["walk", "run"], "pace", []).map(({ kind }) => kind)).toEqual([
    "add_parameter",
    "set_state",
  ]));

test("another value makes a line a pad: its clips keep their places along the line", () => {
  const info = state({ over: ["pace"], points: { walk: [0], run: [2] } });
  expect(blendOver(WALK, info, "pace, turn", [PACE]).at(-1)).toEqual({
    kind: "set_state",
    ...WALK,
    fields: { motion: { over: ["pace", "turn"], clips: { walk: [0, 0], run: [2, 0] } } },
  });
  expect(blendOver(WALK, info, "pace, turn", [PACE])[0]).toMatchObject({
    kind: "add_parameter",
    name: "turn",
  });
  expect(blendOver(WALK, info, "entry speed", [PACE])).toHaveLength(1);
});

const marker = (name: string, phase: number, written = true) => ({ name, phase, written });

test("a blend over another value keeps the markers of its clips", () => {
  const info = state({
    over: ["pace"],
    points: { walk: [0], run: [2] },
    clip_markers: { walk: [marker("left", 0.25), marker("own", 0.5, false)], run: [] },
  });
  expect(blendOver(WALK, info, "entry speed", [PACE])).toEqual([
    {
      kind: "set_state",
      ...WALK,
      fields: {
        motion: { over: "entry speed", clips: { walk: 0, run: 2 }, markers: { walk: { left: 0.25 } } },
      },
    },
  ]);
});

describe("a blend becomes one of its clips", () => {
  const clips = ["walk", "run"];

  test("without markers that none of them had", () =>
    expect(oneClip(WALK, state({ clips, clip_markers: { walk: [], run: [] } }), "run")).toEqual([
      { kind: "set_state", ...WALK, fields: { motion: "run" } },
    ]));

  test.each([
    ["walk", { left: 0.3, half: 0.5, right: 0.75 }],
    ["run", { left: 0.2, half: 0.5 }],
  ])("%s keeps its markers, and phases of the state are those of the first clip", (clip, markers) => {
    const info = state({
      clips,
      clip_markers: { walk: [marker("left", 0.25), marker("right", 0.75)], run: [marker("left", 0.2)] },
      markers: [marker("left", 0.3), marker("half", 0.5), marker("right", 0.75, false)],
    });
    expect(oneClip(WALK, info, clip)).toEqual([
      { kind: "set_state", ...WALK, fields: { motion: clip, markers } },
    ]);
  });
});
