// @vitest-environment happy-dom
import { describe, expect, it } from "vitest";
import { layer, state } from "../net/types/examples";
import { exampleApp, watch } from "../view/exampleApp";
import { filtered } from "./nameFilter";

describe("the filter", () => {
  it("takes parts of names", () =>
    expect(filtered(["RUN", "WALK", "STWK"], "wk al")).toEqual(["WALK", "STWK"]));
  it("leaves all if none has one", () => expect(filtered(["RUN"], "jump")).toEqual(["RUN"]));
});

it("is given up with another machine", () => {
  const app = exampleApp();
  const states = ["WALK", "RUN"].map((name) => state({ name }));
  watch(app, { layers: [layer({ states })] });
  app.nameFilter.text.value = "wal";
  watch(app, { version: 2, layers: [layer({ states })] });
  const kept = app.nameFilter.apply(layer({ states }), ["GO"]);
  expect([kept.states.map(({ name }) => name), kept.events]).toEqual([["WALK"], ["GO"]]);
  watch(app, { name: "other", layers: [layer({ states })] });
  expect(app.nameFilter.text.value).toBe("");
});
