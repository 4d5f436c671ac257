import { expect, test } from "vitest";
import { keyBinding, layer, machine, state } from "../../net/types/examples";
import { usersEvents } from "./usersEvents";

const step = { name: "left-down", phase: 0, written: true };
const shout = { name: "shout", phase: 0.5, written: true };

test("ends and markers are raised by motions, and are not the user's", () => {
  const info = machine({
    events: ["GO", "left-down", "shout", "END"],
    states: [state({ markers: [step] })],
    layers: [layer({ states: [state({ markers: [shout] })] })],
  });
  expect(usersEvents(info)).toEqual(["GO"]);
});

test("a marker that a key raises too is the user's", () => {
  const keys = { l: keyBinding({ press: "left-down" }) };
  const info = machine({ events: ["GO", "left-down"], states: [state({ markers: [step] })], keys });
  expect(usersEvents(info)).toEqual(["GO", "left-down"]);
});
