// @vitest-environment happy-dom
import { expect, it } from "vitest";
import type { ClientMessage } from "../net/protocol";
import { exampleApp, watch } from "../view/exampleApp";

const app = exampleApp();
const sent: ClientMessage[] = [];
Object.assign(app.line, { send: (message: ClientMessage) => sent.push(message) > 0 });

it("keeps what follows an event in the past until the server has answered", () => {
  watch(app, {});
  app.playback.look(0);
  sent.length = 0;
  app.session.event("hold", "JUMP");
  app.session.event("release", "JUMP");
  expect(sent).toMatchObject([{ kind: "hold", tick: 0 }]);
  app.line.messages.emit({ type: "accepted", ref: "a", tick: 0, seq: 1, stage: "main" });
  expect(sent[1]).toEqual({
    type: "event",
    kind: "release",
    actor: 1,
    event: "JUMP",
    ref: "event 2",
    now: true,
  });
});
