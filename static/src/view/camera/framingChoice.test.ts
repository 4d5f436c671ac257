// @vitest-environment happy-dom
import { expect, test } from "vitest";
import * as example from "../../net/types/examples";
import { exampleApp, watch } from "../exampleApp";
import { FramingChoice } from "./framingChoice";

const LAYERS = [
  example.layer({
    states: [
      example.state({ name: "STAND" }),
      example.state({ name: "GREET", framing: "upper body" }),
      example.state({ name: "WAVE", framing: "upper body" }),
    ],
  }),
  example.layer({
    name: "face",
    states: [example.state({ name: "CALM" }), example.state({ name: "SMILE", framing: "face" })],
  }),
];

interface Chosen {
  made: FramingChoice;
  /** How often a state has moved the camera. */
  moves: () => number;
  enter: (states: readonly string[]) => void;
}

function choice(camera: number[] | null = null): Chosen {
  const app = exampleApp();
  app.viewpoint.ask(camera);
  const made = new FramingChoice(app);
  let moves = 0;
  made.staged.on(() => moves++);
  watch(app, { layers: LAYERS });
  return { made, moves: () => moves, enter: (states) => app.selection.tellStates(states) };
}

test("a state that asks for a framing has it; a state that asks for none gives back the user's", () => {
  const { made, moves, enter } = choice();
  enter(["STAND", "CALM"]);
  expect([made.shown.value, moves()]).toEqual(["whole", 0]);
  made.choose("wide");
  enter(["GREET", "CALM"]);
  expect([made.shown.value, moves()]).toEqual(["upper body", 1]);
  enter(["WAVE", "CALM"]);
  expect(moves()).toBe(1); // the same framing: the camera stays the user's
  enter(["WAVE", "SMILE"]);
  expect([made.shown.value, moves()]).toEqual(["face", 2]);
  enter(["STAND", "CALM"]);
  expect([made.shown.value, moves()]).toEqual(["wide", 3]);
});

test("the user's choice counts until the next state that asks for another framing", () => {
  const { made, enter } = choice();
  enter(["GREET", "CALM"]);
  made.choose("whole");
  enter(["WAVE", "CALM"]);
  expect(made.shown.value).toBe("whole");
  enter(["WAVE", "SMILE"]);
  expect(made.shown.value).toBe("face");
});

test("a camera of the address stays until a state begins", () => {
  const { made, moves, enter } = choice([3, 1, 0, 0, 1, 0]);
  enter(["GREET", "CALM"]);
  expect([made.shown.value, moves()]).toEqual(["upper body", 0]);
  enter(["STAND", "CALM"]);
  expect([made.shown.value, moves()]).toEqual(["whole", 1]);
});
