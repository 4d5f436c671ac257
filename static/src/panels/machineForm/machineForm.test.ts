// @vitest-environment happy-dom
import { describe, expect, it, test } from "vitest";
import { cell, keyBinding, layer, machine, parameter } from "../../net/types/examples";
import type { Operation } from "../../net/protocol";
import { exampleApp, watch } from "../../view/exampleApp";
import { defaultPlaces } from "./defaultCells";
import type { Section } from "./entries";
import { keySection, newKey } from "./keys";
import { layerSection } from "./layers";
import { machineFormPanel } from "./machineForm";
import { parameterSection } from "./parameters";
import { newSense, senseSection } from "./senses";
import { aboutSection, defaultsSection } from "./settings";
import { numberOrName } from "../../state/fieldTexts";

/** Returns the operations of a text in the field `label` of an entry. */
function typed({ entries }: Section, name: string, label: string, text: string): readonly Operation[] {
  const entry = entries.find((known) => known.name === name)!;
  return entry.fields.find((field) => field.label === label)!.means(text);
}

const vector = (axis: string, value: number) =>
  parameter({ name: `gaze.${axis}`, vector: "gaze", kind: "point", default: value });
const PARAMETERS = [vector("x", 1), vector("y", 2), vector("z", 3), parameter({ name: "pace" })];

describe("a parameter", () => {
  const section = parameterSection(machine({ parameters: PARAMETERS }));
  const fieldsOf = (name: string) => section.entries.find((entry) => entry.name === name)!.fields;

  it("of several numbers is one entry", () =>
    expect(section.entries.map(({ name }) => name)).toEqual(["gaze", "pace"]));

  it("shows its numbers together", () =>
    expect(fieldsOf("gaze").find(({ label }) => label === "default")!.value).toBe("1, 2, 3"));

  it("of another kind gets a default of that kind, and no bounds", () =>
    expect(typed(section, "pace", "kind", "point")).toEqual([
      {
        kind: "set_parameter",
        name: "pace",
        fields: { kind: "point", default: [0, 0, 0], min: null, max: null, handle: null },
      },
    ]));

  it("wants all of its numbers", () =>
    expect(() => typed(section, "gaze", "default", "1, 2")).toThrow("3 numbers"));

  it("moves before the one above it", () =>
    expect(section.entries[1]!.earlier).toEqual([
      { kind: "move_entry", section: "parameters", name: "pace", before: "gaze" },
    ]));
});

describe("a sense", () => {
  it("has a condition", () =>
    expect(newSense("NEAR: distance < 2")).toEqual([
      { kind: "add_sense", name: "NEAR", fields: { when: "distance < 2" } },
    ]));

  it("or a touch", () =>
    expect(newSense("HIT: touch hand, ball")).toEqual([
      { kind: "add_sense", name: "HIT", fields: { touch: ["hand", "ball"] } },
    ]));

  it("says what is missing", () => expect(() => newSense("NEAR")).toThrow("as in: NEAR: distance < 2"));

  it("is raised again by default: its release goes", () =>
    expect(
      typed(
        senseSection(machine({ senses: { NEAR: { when: "a", release: "b" } } })),
        "NEAR",
        "again after",
        "",
      ),
    ).toEqual([{ kind: "set_sense", name: "NEAR", fields: { release: null } }]));
});

describe("a key", () => {
  const change = { REACH: { "aim.x": 0.5, pace: 1 }, "*": { pace: -2 } };
  const keys = {
    w: keyBinding({ press: "FORWARD", hold: true, release: "STOP" }),
    x: keyBinding({ change }),
  };
  const section = keySection(machine({ keys, events: ["FORWARD", "STOP", "END"] }));
  const moves = "REACH: aim.x 0.5, pace 1; pace -2";

  it.each([
    ["j: JUMP", { press: "JUMP" }],
    ["Space: hold FORWARD", { hold: "FORWARD" }],
    [":: change pace 0.5", { change: { "*": { pace: 0.5 } } }],
  ])("is made by %s", (text, fields) =>
    expect(newKey(text)).toEqual([
      { kind: "add_key", name: text[0] === ":" ? ":" : text.split(":")[0], fields },
    ]),
  );

  it("that gets another name keeps its place and what it does", () =>
    expect(section.entries[0]!.rename!("q")).toEqual([
      { kind: "delete_entry", section: "keys", name: "w" },
      { kind: "add_key", name: "q", fields: { hold: "FORWARD", release: "STOP" }, before: "x" },
    ]));

  it("sends once instead of all the time", () =>
    expect(typed(section, "w", "sends it", "press")).toEqual([
      { kind: "set_key", name: "w", fields: { press: "FORWARD", hold: null } },
    ]));

  it("has its rates in words, which can be read", () => {
    expect(section.entries[1]!.fields[0]!.value).toBe(moves);
    expect(typed(section, "x", "moves, a second", moves)).toEqual([
      { kind: "set_key", name: "x", fields: { change } },
    ]);
  });

  it("says what is wrong with a rate", () =>
    expect(() => typed(section, "x", "moves, a second", "pace fast")).toThrow("as in: pace 0.5"));
});

test("the base is no entry of the layers", () => {
  const layers = [layer({ name: "base" }), layer({ name: "arms", mask: ["Spine"] })];
  expect(layerSection(machine({ layers })).entries.map(({ name }) => name)).toEqual(["arms"]);
});

test("a weight is a number or a parameter", () =>
  expect(["0.5", "look", ""].map(numberOrName)).toEqual([0.5, "look", null]));

describe("feet that hold", () => {
  const about = (foot_lock: number | string) => aboutSection(machine({ foot_lock, parameters: PARAMETERS }));
  const shown = (foot_lock: number | string) =>
    about(foot_lock).entries[0]!.fields.find(({ label }) => label === "feet hold")!;

  it.each([
    [0, ""],
    [1, "1"],
    ["pace", "pace"],
  ])("are shown as %s", (lock, text) => expect(shown(lock).value).toBe(text));

  it("propose numbers, not points", () => expect(shown(0).proposals).toEqual(["1", "pace"]));

  it.each([
    ["0.5", 0.5],
    ["pace", "pace"],
    ["", null],
  ])("are set by %s", (text, foot_lock) =>
    expect(typed(about(0), "machine", "feet hold", text)).toEqual([
      { kind: "set_machine", fields: { foot_lock } },
    ]),
  );
});

test("another curve keeps the default blend's time", () =>
  expect(typed(defaultsSection(machine({})), "defaults", "curve", "quintic")).toEqual([
    { kind: "set_defaults", fields: { blend: { seconds: 0.2, curve: "quintic" } } },
  ]));

test("defaults of rows and columns are found once each", () => {
  const row = cell({ source: "row", written: ["WALK", "*"] });
  const table = { WALK: { LEFT: row, RIGHT: row, STOP: cell({ written: ["WALK", "STOP"] }) } };
  expect(defaultPlaces(layer({ table }))).toEqual([["WALK", "*"]]);
});

test("the keyboard stays at an entry that is renamed, and goes to the section when the last is deleted", async () => {
  const app = exampleApp();
  const host = document.body.appendChild(document.createElement("div"));
  app.inspection.drawer.value = "machine";
  machineFormPanel(host, app);
  watch(app, { parameters: [parameter({ name: "pace" })] });
  const focused = (): string | undefined => (document.activeElement as HTMLInputElement).value;
  host.querySelector<HTMLInputElement>("[data-section=parameters] fieldset input")!.focus();
  watch(app, { version: 2, parameters: [parameter({ name: "stride" })] });
  await Promise.resolve();
  expect(focused()).toBe("stride");
  watch(app, { version: 3, parameters: [] });
  await Promise.resolve();
  expect(document.activeElement?.tagName).toBe("SUMMARY");
});

test("each section has a command that opens it and leads the keyboard there", () => {
  const app = exampleApp();
  const host = document.body.appendChild(document.createElement("div"));
  machineFormPanel(host, app);
  watch(app, { layers: [layer({})] });
  const commands = app.commands.all.value;
  for (const { act } of commands) act();
  const sections = [...host.querySelectorAll("details")];
  expect(sections.map(({ open }) => open)).toEqual(commands.map(() => true));
  expect(document.activeElement?.parentElement?.dataset["section"]).toBe("properties");
});
