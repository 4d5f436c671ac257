// @vitest-environment happy-dom
import { expect, test, vi } from "vitest";
import { exampleApp, watch } from "../../view/exampleApp";
import { pickerPanel } from "./picker";

const two = [
  { id: 1, name: "one" },
  { id: 2, name: "<b>two</b>" },
];

function shown() {
  const app = exampleApp();
  const host = document.createElement("div");
  pickerPanel(host, app);
  const row = { description: "", character: "c", states: [], events: [] };
  app.library.machines.value = ["m", "n"].map((name) => ({ ...row, name, title: `The ${name}`, scene: "" }));
  app.library.scenes.value = [{ name: "s", title: "Scene", description: "many", actors: 9 }];
  const select = (name: string): HTMLSelectElement => host.querySelector(`select[aria-label=${name}]`)!;
  return { app, machines: select("machine"), actors: select("actor") };
}

const texts = ({ options }: HTMLSelectElement): string[] => [...options].map(({ text }) => text);

test("lists machines and scenes, and selects what is watched", () => {
  const { app, machines } = shown();
  watch(app, { name: "n" });
  expect(texts(machines)).toEqual(["The m", "The n", "Scene"]);
  expect(machines.value).toBe("n");
});

test("machines with the same title are told apart by their names", () => {
  const { app, machines } = shown();
  const [one, other] = app.library.machines.value;
  app.library.machines.value = [one!, other!, { ...one!, name: "m-2" }];
  expect(texts(machines).slice(0, 3)).toEqual(["The m · m", "The n", "The m · m-2"]);
});

test("a machine of a scene is chosen by its scene", () => {
  const { app, machines } = shown();
  app.library.machines.value = app.library.machines.value.map((row) => ({ ...row, scene: "s" }));
  watch(app, { name: "m" });
  expect(machines.value).toBe("scene:s");
});

test("actors are listed if there are several, their names as text", () => {
  const { app, actors } = shown();
  watch(app, {});
  expect(actors.hidden).toBe(true);
  watch(app, {}, { actors: two });
  expect(actors.hidden).toBe(false);
  expect(texts(actors)).toEqual(["one", "<b>two</b>"]);
});

test("a choice of an actor watches the actor, one of a scene opens the scene", () => {
  const { app, machines, actors } = shown();
  watch(app, {}, { actors: two });
  actors.value = "2";
  actors.dispatchEvent(new Event("change"));
  expect(app.selection.actor.value).toBe(2);
  const open = vi.spyOn(app.library, "openScene").mockResolvedValue();
  machines.value = "scene:s";
  machines.dispatchEvent(new Event("change"));
  expect(open).toHaveBeenCalledWith("s");
});
