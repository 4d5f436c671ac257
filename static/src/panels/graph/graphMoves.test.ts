import { expect, it } from "vitest";
import { stateTowards } from "./graphMoves";

const box = (name: string, x: number, y: number) => ({ name, x, y, width: 50 });
const BOXES = [box("A", 0, 0), box("NEAR", 100, 0), box("JOINED", 200, 20), box("UP", 0, -100)];
const EDGES = [{ from: "JOINED", to: "A", events: ["E"] }];

it.each([
  ["along an arrow first, in either direction", "ArrowRight", "JOINED"],
  ["to any state if no arrow leads there", "ArrowUp", "UP"],
  ["nowhere if nothing lies there", "ArrowLeft", null],
  ["nowhere by other keys", "x", null],
])("leads %s", (_, key, to) => expect(stateTowards("A", key, BOXES, EDGES)).toBe(to));
