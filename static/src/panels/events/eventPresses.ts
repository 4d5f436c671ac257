/**
 * Turns presses of buttons into events: what the key does; a tap lasts until the motion has answered. Without a key, a
 * tap presses and a long press holds.
 */

import { HeldKeys, type Sender } from "../../state/keyBindings";
import type { KeyBinding } from "../../net/protocol";

const LONG_PRESS_MS = 300;

/** Returns the binding that a button without a key stands for. */
const keyFor = (event: string, hold: boolean): KeyBinding => ({
  press: event,
  hold,
  release: null,
  change: {},
});

/** A press of a button whose release is an event, too. */
interface Tap {
  readonly began: number;
  readonly answer: Promise<void>;
  isOver: boolean;
}

export class EventPresses {
  private readonly held: HeldKeys;
  private readonly timers = new Map<string, ReturnType<typeof setTimeout>>();
  private readonly taps = new Map<string, Tap>();

  /** `sender` is asked when a press begins; `answer` begins to wait for a motion's answer. */
  constructor(
    sender: () => Sender,
    private readonly answer: () => Promise<void>,
  ) {
    this.held = new HeldKeys(sender);
    for (const end of ["blur", "pagehide"]) window.addEventListener(end, () => this.letGo());
  }

  /** Releases all at once. */
  letGo(): void {
    this.taps.clear();
    this.held.releaseAll();
  }

  /** Begins to press the button of `event`; `binding`: of its first key, if it has one. */
  begin(event: string, binding: KeyBinding | undefined): void {
    if (binding?.release)
      this.taps.set(event, { began: performance.now(), answer: this.answer(), isOver: false });
    this.held.press(event, binding ?? keyFor(event, false));
    if (binding) return;
    const hold = (): void => void this.held.press(`${event} held`, keyFor(event, true));
    this.timers.set(event, setTimeout(hold, LONG_PRESS_MS));
  }

  end(event: string): void {
    clearTimeout(this.timers.get(event));
    this.held.release(`${event} held`);
    const tap = this.taps.get(event);
    if (tap?.isOver) return; // the pointer leaves the button later
    if (!tap || performance.now() - tap.began >= LONG_PRESS_MS) return this.release(event);
    tap.isOver = true;
    void tap.answer.then(() => {
      if (this.taps.get(event) === tap) this.release(event);
    });
  }

  private release(event: string): void {
    this.taps.delete(event);
    this.held.release(event);
  }
}
