/**
 * Shows a button for every event. It does what its key does; without a key, a tap presses and a long press
 * holds.
 */

import "./events.css";
import { HeldKeys, type Intent, cap, mainEvent } from "../../state/keyBindings";
import type { KeyBinding, MachineInfo, Verdict } from "../../net/protocol";
import type { App } from "../../view/app";
import { el, flash } from "../../ui/dom";
import { Keyboard } from "./keyboard";

const LONG_PRESS_MS = 300;
/** With more buttons than this they are drawn smaller. */
const MANY = 8;

/** Returns the binding that a button without a key stands for. */
const keyFor = (event: string, hold: boolean): KeyBinding => ({
  press: event,
  hold,
  release: null,
  change: {},
});

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

class EventsPanel {
  private buttons = new Map<string, HTMLButtonElement>();
  private readonly held: HeldKeys;

  constructor(
    private readonly host: HTMLElement,
    private readonly app: App,
  ) {
    this.held = new HeldKeys(({ kind, event }: Intent) => app.session.event(kind, event));
    app.machine.info.subscribe((machine) => {
      if (machine) this.draw(machine);
    });
    app.session.verdicts.on((verdict) => this.judge(verdict));
    for (const end of ["blur", "pagehide"]) window.addEventListener(end, () => this.held.releaseAll());
  }

  private draw(machine: MachineInfo): void {
    const events = machine.events.filter((event) => event !== "END");
    this.buttons = new Map(events.map((event) => [event, this.button(event, keysFor(event, machine.keys))]));
    this.host.classList.toggle("many", events.length > MANY);
    this.host.replaceChildren(...this.buttons.values());
  }

  private button(event: string, keyed: Keyed[]): HTMLButtonElement {
    const caps = keyed.map(({ key }) => el("kbd", {}, cap(key)));
    const made = el(
      "button",
      { type: "button", class: "event", "data-event": event },
      el("span", {}, event),
      ...caps,
    );
    const binding = keyed[0]?.binding;
    made.addEventListener(
      "pointerdown",
      (pointer) => pointer.button === 0 && this.down(made, event, binding),
    );
    for (const end of ["pointerup", "pointercancel", "pointerleave"])
      made.addEventListener(end, () => this.up(made, event));
    // `detail` is 0 if the keyboard clicks.
    made.addEventListener("click", (click) => click.detail === 0 && this.app.session.event("press", event));
    return made;
  }

  private down(button: HTMLButtonElement, event: string, binding: KeyBinding | undefined): void {
    this.held.press(event, binding ?? keyFor(event, false));
    if (binding) return;
    button.dataset["timer"] = String(
      setTimeout(() => this.held.press(`${event} held`, keyFor(event, true)), LONG_PRESS_MS),
    );
  }

  private up(button: HTMLButtonElement, event: string): void {
    clearTimeout(Number(button.dataset["timer"]));
    this.held.release(`${event} held`);
    this.held.release(event);
  }

  /** Shows a button as held down. */
  press(event: string, down: boolean): void {
    this.buttons.get(event)?.classList.toggle("down", down);
  }

  private judge({ event, verdict }: Verdict): void {
    const button = this.buttons.get(event);
    if (button) flash(button, verdict);
  }
}

export function eventsPanel(host: HTMLElement, app: App): void {
  const panel = new EventsPanel(host, app);
  new Keyboard(app, (event, down) => panel.press(event, down));
}
