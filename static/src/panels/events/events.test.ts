// @vitest-environment happy-dom
import { expect, test, vi } from "vitest";
import { keyBinding, verdict } from "../../net/types/examples";
import { exampleApp, watch } from "../../view/exampleApp";
import { eventsPanel } from "./events";

const keys = { ArrowUp: keyBinding({ press: "FORWARD", release: "STOP" }) };

function shown() {
  const app = exampleApp();
  const host = document.createElement("section");
  const sent: string[] = [];
  vi.spyOn(app.session.inputs, "sender").mockReturnValue(
    ({ kind, event }) => void sent.push(`${kind} ${event}`),
  );
  eventsPanel(host, app);
  watch(app, { events: ["FORWARD", "STOP", "END"], keys });
  const button = (event: string): HTMLButtonElement => host.querySelector(`[data-event=${event}]`)!;
  return { app, host, sent, button };
}

const point = (button: Element, type: string): boolean => button.dispatchEvent(new PointerEvent(type));

test("each event has a button with its keys; the end of a motion is no event", () => {
  const { host } = shown();
  expect([...host.children].map((button) => button.textContent.trim())).toEqual(["FORWARD↑", "STOP"]);
});

test("the filter of a large table chooses the buttons, too", async () => {
  const { app, host } = shown();
  app.nameFilter.text.value = "stop";
  await Promise.resolve();
  expect([...host.children].map((button) => button.textContent.trim())).toEqual(["STOP"]);
});

test("a button that is held does what its key does", () => {
  vi.useFakeTimers();
  const { sent, button } = shown();
  point(button("FORWARD"), "pointerdown");
  vi.advanceTimersByTime(400);
  point(button("FORWARD"), "pointerup");
  vi.useRealTimers();
  expect(sent).toEqual(["press FORWARD", "press STOP"]);
});

test("a tap lasts until the state that it begins has ended", async () => {
  const { app, sent, button } = shown();
  for (const type of ["pointerdown", "pointerup", "pointerleave"]) point(button("FORWARD"), type);
  for (const state of [1, null, 1]) app.selection.state.value = state;
  await Promise.resolve();
  expect(sent).toEqual(["press FORWARD"]);
  app.selection.state.value = 2;
  await Promise.resolve();
  expect(sent).toEqual(["press FORWARD", "press STOP"]);
});

test("a tap that no state answers lasts for a while", async () => {
  vi.useFakeTimers();
  const { sent, button } = shown();
  for (const type of ["pointerdown", "pointerup"]) point(button("FORWARD"), type);
  await vi.advanceTimersByTimeAsync(3000);
  vi.useRealTimers();
  expect(sent).toEqual(["press FORWARD", "press STOP"]);
});

test("a long press of a button without a key holds", () => {
  vi.useFakeTimers();
  const { sent, button } = shown();
  point(button("STOP"), "pointerdown");
  vi.advanceTimersByTime(1000);
  point(button("STOP"), "pointerleave");
  vi.useRealTimers();
  expect(sent).toEqual(["press STOP", "hold STOP", "release STOP"]);
});

test("a key that is down shows on its button, and a verdict flashes", () => {
  const { app, button } = shown();
  window.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowUp" }));
  expect(button("FORWARD").className.trim()).toBe("event down");
  app.session.verdicts.emit(verdict({ event: "FORWARD" }));
  window.dispatchEvent(new KeyboardEvent("keyup", { key: "ArrowUp" }));
  expect([...button("FORWARD").classList]).toEqual(["event", "taken"]);
});
