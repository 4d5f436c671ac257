// @vitest-environment happy-dom
import { signal } from "@preact/signals-core";
import { beforeEach, describe, expect, it, vi } from "vitest";
import type { MachineInfo } from "../net/protocol";
import type { Line } from "./line";
import { ParameterValues } from "./parameterValues";
import type { Selection } from "./selection";
import type { WatchedMachine } from "./watchedMachine";
import type { WatchedStage } from "./watchedStage";

/** Answers the requests that wait. */
let answers: ((answer: Response) => void)[];

beforeEach(() => {
  answers = [];
  vi.stubGlobal("fetch", () => new Promise<Response>((done) => answers.push(done)));
});

const component = (vector: string, kind: string, name: string, value: number) => ({
  ...{ vector, kind, name: `${vector}.${name}`, minimum: -1, maximum: 1 },
  default: value,
});
const machine = {
  name: "toy",
  parameters: [
    { vector: "", kind: "number", name: "pace", minimum: 0, maximum: 2, default: 1 },
    ...["x", "y", "z"].map((name) => component("side", "direction", name, 0.5)),
    ...["x", "y", "z", "w"].map((name) => component("turn", "rotation", name, name === "w" ? 1 : 0)),
  ],
} as unknown as MachineInfo;

function shown(sent: unknown[] = []): ParameterValues {
  return new ParameterValues(
    { send: (message: unknown) => sent.push(message) } as unknown as Line,
    { id: "main", hello: signal(null) } as unknown as WatchedStage,
    { actor: signal(3) } as unknown as Selection,
    { info: signal(machine) } as unknown as WatchedMachine,
  );
}

function sentAfter(name: string, value: number): unknown[] {
  const sent: unknown[] = [];
  shown(sent).set(name, value);
  return sent;
}

describe("a parameter that is set", () => {
  it.each([
    ["pace", 5, "pace", 2],
    ["side.y", 1, "side", [0.5, 1, 0.5]],
    ["turn.x", 0.25, "turn", [0.25, 0, 0, 1]],
  ])("%s goes out whole, and within its range", (name, value, parameter, whole) => {
    expect(sentAfter(name, value)).toEqual([{ type: "set", parameter, value: whole, actor: 3 }]);
  });
});

it("a value that is set while the server's answer is on its way is kept, the others are taken from the answer", async () => {
  const values = shown();
  values.set("pace", 2);
  const facts = { machine: "toy", parameters: { pace: 0, side: [1, 0, 0], turn: [0, 0, 0, 1] } };
  for (const answer of answers) answer(Response.json(facts));
  await vi.waitFor(() => expect(values.point("side")).toEqual([1, 0, 0]));
  expect(values.get("pace")).toBe(2);
});
