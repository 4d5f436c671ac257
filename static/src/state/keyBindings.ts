/** Turns the machine's keys into events: key down presses or holds, key up releases. */

import type { EventKind, KeyBinding } from "../net/protocol";

export interface Intent {
  kind: EventKind;
  event: string;
}

/** Returns the event that is held while the key is down, or null. */
const heldEvent = ({ hold, press }: KeyBinding): string | null => (hold ? press : null);

/** Returns the intents of a key that goes down. */
export function onDown(binding: KeyBinding): Intent[] {
  const held = heldEvent(binding);
  const pressed =
    binding.press && binding.press !== held ? [{ kind: "press" as const, event: binding.press }] : [];
  return held ? [...pressed, { kind: "hold", event: held }] : pressed;
}

/**
 * Returns the intents of a key that comes up: the held event is released, then the release event is pressed.
 */
export function onUp(binding: KeyBinding): Intent[] {
  const held = heldEvent(binding);
  const letGo: Intent[] = held ? [{ kind: "release", event: held }] : [];
  return binding.release ? [...letGo, { kind: "press", event: binding.release }] : letGo;
}

/** Returns the event whose button shows this key. */
export function mainEvent(binding: KeyBinding): string | null {
  return binding.press;
}

const CAPS: Record<string, string> = {
  ArrowUp: "↑",
  ArrowDown: "↓",
  ArrowLeft: "←",
  ArrowRight: "→",
  " ": "space",
  Space: "space",
  Enter: "↵",
  Escape: "esc",
  Shift: "⇧",
  Control: "ctrl",
  Backspace: "⌫",
  PageUp: "PgUp",
  PageDown: "PgDn",
  Tab: "⇥",
};

/** Returns the label of a key's cap. */
export function cap(key: string): string {
  return CAPS[key] ?? (key.length === 1 ? key.toUpperCase() : key.replace(/^(Key|Digit)/, ""));
}

/** Finds the binding for a keyboard event: by `key` in any case, or by `code`; a space is also "Space". */
export function bindingOf(keys: Record<string, KeyBinding>, key: string, code: string): string | null {
  const wanted = new Set([key, key.toLowerCase(), key.toUpperCase(), code, key === " " ? "Space" : key]);
  return Object.keys(keys).find((name) => wanted.has(name)) ?? null;
}

/** Sends what a key does while it is down, and when it comes up. */
export type Sender = (intent: Intent) => void;

/**
 * Keys that are down. Each goes down once and comes up once, even if the keyboard repeats or loses events.
 */
export class HeldKeys {
  private readonly down = new Map<string, { binding: KeyBinding; send: Sender }>();

  /** `sender` is asked when a key goes down. */
  constructor(private readonly sender: () => Sender) {}

  /** Returns false if the key is down already. */
  press(name: string, binding: KeyBinding): boolean {
    if (this.down.has(name)) return false;
    const send = this.sender();
    this.down.set(name, { binding, send });
    onDown(binding).forEach(send);
    return true;
  }

  release(name: string): boolean {
    const held = this.down.get(name);
    if (!held) return false;
    this.down.delete(name);
    onUp(held.binding).forEach(held.send);
    return true;
  }

  /** Releases all keys, for example when the page loses the keyboard. */
  releaseAll(): void {
    for (const name of [...this.down.keys()]) this.release(name);
  }

  has(name: string): boolean {
    return this.down.has(name);
  }
}
