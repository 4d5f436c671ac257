// @vitest-environment happy-dom
import { beforeEach, expect, it, vi } from "vitest";
import { cast, hello } from "../net/types/examples";
import { exampleApp } from "../view/exampleApp";
import { readAddress } from "./address";
import { keepAddress } from "./keepAddress";

/** There is no server to connect to. */
class Silent {
  readonly postMessage = (): undefined => undefined;
}
vi.stubGlobal("Worker", Silent);
const app = exampleApp();
keepAddress(app);
const watch = (stage: string): void => app.stage.greet(hello({ stage }));

beforeEach(() => {
  app.session.gone.emit(null);
  watch("main");
});

it("makes another stage another page of the browser's history, and a reconnection none", () => {
  const before = history.length;
  watch("a");
  watch("a");
  expect([readAddress().stage, history.length - before]).toEqual(["a", 1]);
});

it("replaces a stage that is gone", () => {
  watch("a");
  const before = history.length;
  app.session.gone.emit(null);
  watch("main");
  expect([readAddress().stage, history.length - before]).toEqual([null, 0]);
});

it("looks at the tick and the actor of the address that Back leads to, from its camera, and explains", async () => {
  const casts = [cast({ actors: [1, 2].map((id) => ({ id, name: `actor ${id}` })) })];
  history.replaceState(null, "", "?actor=2&tick=40&why=30&camera=1,2,3,0,1,0&view=free");
  window.dispatchEvent(new PopStateEvent("popstate"));
  app.stage.greet(hello({ head: 90, casts }));
  await Promise.resolve();
  expect([app.selection.actor.value, app.playback.looking.value, app.inspection.why.value]).toEqual([
    2, 40, 30,
  ]);
  expect([app.viewpoint.take(), app.viewpoint.mode.value]).toEqual([[1, 2, 3, 0, 1, 0], "free"]);
});
