/**
 * Shows a button for every event of the user's. It does what its key does; a tap lasts until the motion has answered.
 * Without a key, a tap presses and a long press holds.
 */

import "./events.css";
import { effect, signal } from "@preact/signals-core";
import { html, type TemplateResult } from "lit-html";
import { classMap } from "lit-html/directives/class-map.js";
import { repeat } from "lit-html/directives/repeat.js";
import { cap, mainEvent } from "../../state/keyBindings";
import type { KeyBinding } from "../../net/protocol";
import type { App } from "../../view/app";
import { flash } from "../../ui/dom";
import { draw } from "../../ui/draw";
import { EventPresses } from "./eventPresses";
import { Keyboard } from "./keyboard";
import { motionAnswer } from "./motionAnswer";
import { filtered } from "../../state/nameFilter";
import { usersEvents } from "./usersEvents";

/** With more buttons than this they are drawn smaller. */
const MANY = 8;

interface Keyed {
  key: string;
  binding: KeyBinding;
}

/** Returns the keys that the machine binds to `event`. */
export function keysFor(event: string, keys: Record<string, KeyBinding>): Keyed[] {
  return Object.entries(keys)
    .filter(([, binding]) => mainEvent(binding) === event)
    .map(([key, binding]) => ({ key, binding }));
}

export function eventsPanel(host: HTMLElement, app: App): void {
  const { machine, session, selection, nameFilter } = app;
  const presses = new EventPresses(
    () => session.inputs.sender(),
    () => motionAnswer(selection.state),
  );
  selection.actor.subscribe(() => presses.letGo());
  session.leaving.on(() => session.inputs.isForking || presses.letGo());
  /** The events whose keys are down. */
  const down = signal<ReadonlySet<string>>(new Set());
  new Keyboard(app, (event, isDown) => {
    const others = [...down.value].filter((other) => other !== event);
    down.value = new Set(isDown ? [...others, event] : others);
  });

  const events = (): string[] => (machine.info.value ? usersEvents(machine.info.value) : []);

  function button(event: string): TemplateResult {
    const keyed = keysFor(event, machine.info.value?.keys ?? {});
    const end = (): void => presses.end(event);
    const begin = (pointer: PointerEvent): void => {
      if (pointer.button === 0) presses.begin(event, keyed[0]?.binding);
    };
    // `detail` is 0 if the keyboard clicks.
    const click = ({ detail }: MouseEvent): void => {
      if (detail === 0) session.event("press", event);
    };
    return html`<button
      type="button"
      class=${classMap({ event: true, down: down.value.has(event) })}
      data-event=${event}
      @pointerdown=${begin}
      @pointerup=${end}
      @pointercancel=${end}
      @pointerleave=${end}
      @click=${click}
    >
      <span .textContent=${event}></span>${keyed.map(({ key }) => html`<kbd .textContent=${cap(key)}></kbd>`)}
    </button>`;
  }

  effect(() => {
    host.classList.toggle("many", events().length > MANY);
  });
  draw(host, () => html`${repeat(filtered(events(), nameFilter.text.value), (event) => event, button)}`);
  session.verdicts.on(({ event, verdict }) => {
    const shown = host.querySelector(`[data-event="${CSS.escape(event)}"]`);
    if (shown) flash(shown, verdict);
  });
}
