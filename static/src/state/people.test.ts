// @vitest-environment happy-dom
import { expect, it } from "vitest";
import { hello } from "../net/types/examples";
import type { ClockChange, Status } from "../net/protocol";
import { exampleApp } from "../view/exampleApp";

const app = exampleApp();
const told: unknown[] = [];
app.notices.on((notice) => told.push(notice));
const report = (changed: ClockChange): void =>
  app.line.messages.emit({ ...hello({ changed }), type: "status" } as unknown as Status);

it("tells once what others do to the time, and not what this page does", () => {
  app.stage.greet(hello({ viewer: 3 }));
  report({ what: "paused", by: "Ada", viewer: 2, tick: 40 });
  report({ what: "paused", by: "Ada", viewer: 2, tick: 40 });
  report({ what: "resumed", by: "me", viewer: 3, tick: 50 });
  expect(told).toEqual(["You were paused by Ada, at tick 40."]);
});
