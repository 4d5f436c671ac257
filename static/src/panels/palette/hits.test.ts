// @vitest-environment happy-dom
import { signal } from "@preact/signals-core";
import { expect, it, vi } from "vitest";
import { layer, state } from "../../net/types/examples";
import type { StageInfo } from "../../net/protocol";
import { matching } from "../../ui/matching";
import { exampleApp, watch } from "../../view/exampleApp";
import type { App } from "../../view/app";
import { type Hit, hitsOf } from "./hits";

function examples(...above: string[]): App {
  const app = exampleApp();
  const watched = { jointNames: () => ["hip"], joint: signal(""), traced: signal("") };
  Object.assign(app.view, { watched });
  const layers = [
    layer({ states: [state({ name: "WALK", clips: ["walk"] })] }),
    ...above.map((name) => layer({ name })),
  ];
  watch(app, { layers, events: ["JUMP"] });
  return app;
}

const hit = (app: App, name: string, stages: StageInfo[] = []): Hit =>
  hitsOf(app, stages).find((one) => one.name === name)!;

it("sends an event", () => {
  const app = examples();
  const send = vi.spyOn(app.session, "event");
  hit(app, "JUMP").act();
  expect(send).toHaveBeenCalledWith("press", "JUMP");
});

it("shows a state", () => {
  const app = examples();
  hit(app, "WALK").act();
  expect(app.inspection.selected.value).toEqual({ layer: "base", state: "WALK", event: null });
});

it("shows a joint", () => {
  const app = examples();
  hit(app, "hip").act();
  expect(app.view.watched.joint.value).toBe("hip");
});

it("draws the path of a joint", () => {
  const app = examples();
  matching(hitsOf(app, []), "hip path")[0]!.act();
  expect(app.view.watched.traced.value).toBe("hip");
});

it("shows a layer of a machine that has several", () => {
  const app = examples("face");
  hit(app, "face").act();
  expect(app.selection.layer.value).toBe(1);
});

it("runs a command, and says its key", () => {
  const app = examples();
  const act = vi.fn();
  app.commands.add({ words: "frame the character", keys: ["f"], act });
  const command = hit(app, "frame the character");
  command.act();
  expect([command.note, act.mock.calls.length]).toEqual(["F", 1]);
});

it("watches a stage", () => {
  const app = examples();
  const watching = vi.spyOn(app.session, "watch").mockReturnValue();
  hit(app, "Idea B", [
    { id: "b", name: "Idea B", scene: null, machines: ["m"] } as unknown as StageInfo,
  ]).act();
  expect(watching).toHaveBeenCalledWith("b");
});

it("finds a machine by the title that the list of machines shows, and by its name", () => {
  const app = examples();
  app.library.machines.value = [
    { name: "faq-printed", title: "The table as printed", scene: "" },
  ] as unknown as typeof app.library.machines.value;
  const open = vi.spyOn(app.library, "openMachine").mockResolvedValue();
  for (const typed of ["as printed", "faq-printed"]) matching(hitsOf(app, []), typed)[0]!.act();
  expect(open.mock.calls).toEqual([["faq-printed"], ["faq-printed"]]);
});

it("finds what a state does by its note", () => {
  const found = matching(hitsOf(examples(), []), "walk travel");
  expect(found.map(({ name, note }) => [name, note])).toEqual([["WALK", "state: travel there"]]);
});
