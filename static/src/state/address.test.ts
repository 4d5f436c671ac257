// @vitest-environment happy-dom
import { beforeEach, expect, it } from "vitest";
import { hello } from "../net/types/examples";
import { exampleApp } from "../view/exampleApp";
import { keepAddress, stageOfAddress } from "./address";

const app = exampleApp();
keepAddress(app.stage, app.stages, app.session);
const watch = (stage: string): void => app.stage.greet(hello({ stage }));

beforeEach(() => {
  app.session.gone.emit(null);
  watch("main");
});

it("makes another stage another page of the browser's history, and a reconnection none", () => {
  const before = history.length;
  watch("a");
  watch("a");
  expect([stageOfAddress(), history.length - before]).toEqual(["a", 1]);
});

it("replaces a stage that is gone", () => {
  watch("a");
  const before = history.length;
  app.session.gone.emit(null);
  watch("main");
  expect([stageOfAddress(), history.length - before]).toEqual([null, 0]);
});
