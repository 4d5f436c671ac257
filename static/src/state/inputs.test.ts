// @vitest-environment happy-dom
import { beforeEach, expect, it } from "vitest";
import type { ClientMessage } from "../net/protocol";
import { exampleApp, watch } from "../view/exampleApp";

const app = exampleApp();
const sent: ClientMessage[] = [];
Object.assign(app.line, { send: (message: ClientMessage) => sent.push(message) > 0 });

beforeEach(() => {
  watch(app, {});
  app.playback.live();
  app.session.inputs.forget();
  sent.length = 0;
});

it("sends what began in the present to the present, though the page looks at the past by then", () => {
  const send = app.session.inputs.sender();
  send({ kind: "hold", event: "JUMP" });
  app.playback.look(0);
  send({ kind: "release", event: "JUMP" });
  expect(sent).toMatchObject([
    { kind: "hold", now: true },
    { kind: "release", now: true },
  ]);
});

it("sends what begins in the past there, and keeps what follows for the fork", () => {
  app.playback.look(0);
  const send = app.session.inputs.sender();
  send({ kind: "hold", event: "JUMP" });
  send({ kind: "release", event: "JUMP" });
  expect(sent).toMatchObject([{ kind: "hold", tick: 0 }]);
  app.session.inputs.sendWaiting();
  expect(sent[1]).toMatchObject({ kind: "release", now: true });
});
