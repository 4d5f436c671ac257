/** Turns presses of buttons into events: what the key does; without a key, a tap presses and a long press holds. */

import { HeldKeys, type Intent } from "../../state/keyBindings";
import type { KeyBinding } from "../../net/protocol";

const LONG_PRESS_MS = 300;

/** Returns the binding that a button without a key stands for. */
const keyFor = (event: string, hold: boolean): KeyBinding => ({
  press: event,
  hold,
  release: null,
  change: {},
});

export class EventPresses {
  private readonly held: HeldKeys;
  private readonly timers = new Map<string, ReturnType<typeof setTimeout>>();

  constructor(send: (intent: Intent) => void) {
    this.held = new HeldKeys(send);
    for (const end of ["blur", "pagehide"]) window.addEventListener(end, () => this.held.releaseAll());
  }

  /** Begins to press the button of `event`; `binding`: of its first key, if it has one. */
  begin(event: string, binding: KeyBinding | undefined): void {
    this.held.press(event, binding ?? keyFor(event, false));
    if (binding) return;
    const hold = (): void => void this.held.press(`${event} held`, keyFor(event, true));
    this.timers.set(event, setTimeout(hold, LONG_PRESS_MS));
  }

  end(event: string): void {
    clearTimeout(this.timers.get(event));
    this.held.release(`${event} held`);
    this.held.release(event);
  }
}
