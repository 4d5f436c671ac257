/** Keys of the machine become events: down is press or hold, up is release; and the viewer's own keys, where the machine leaves them free. */

import type { EventKind, KeyBinding } from "./net/protocol";

export interface Intent {
  kind: EventKind;
  event: string;
}

/** The event a binding holds while its key is down, or null. `hold` names it, or says that `press` is held. */
function heldEvent({ hold, press }: KeyBinding): string | null {
  if (typeof hold === "string" && hold) return hold;
  return hold === true ? (press ?? null) : null;
}

/** What going down of a key with this binding means. */
export function onDown(binding: KeyBinding): Intent[] {
  const held = heldEvent(binding);
  const pressed = binding.press && binding.press !== held ? [{ kind: "press" as const, event: binding.press }] : [];
  return held ? [...pressed, { kind: "hold", event: held }] : pressed;
}

/** What coming up means: the held event is let go, then the release event is pressed. */
export function onUp(binding: KeyBinding): Intent[] {
  const held = heldEvent(binding);
  const letGo: Intent[] = held ? [{ kind: "release", event: held }] : [];
  return binding.release ? [...letGo, { kind: "press", event: binding.release }] : letGo;
}

/** The event a binding is known by, for key caps and buttons. */
export function mainEvent(binding: KeyBinding): string | null {
  return heldEvent(binding) ?? binding.press ?? null;
}

const CAPS: Record<string, string> = {
  ArrowUp: "↑", ArrowDown: "↓", ArrowLeft: "←", ArrowRight: "→", " ": "space", Space: "space", Enter: "↵", Escape: "esc", Shift: "⇧", Control: "ctrl", Backspace: "⌫", Tab: "⇥",
};

/** How a key looks on its cap. */
export function cap(key: string): string {
  return CAPS[key] ?? (key.length === 1 ? key.toUpperCase() : key.replace(/^(Key|Digit)/, ""));
}

/** The binding's name for what the keyboard says: `key` (any case) or `code`, a space also as "Space". */
export function bindingOf(keys: Record<string, KeyBinding>, key: string, code: string): string | null {
  const wanted = new Set([key, key.toLowerCase(), key.toUpperCase(), code, key === " " ? "Space" : key]);
  return Object.keys(keys).find((name) => wanted.has(name)) ?? null;
}

/** Keys that are down; each goes down once and comes up once, whatever the keyboard repeats or forgets. */
export class HeldKeys {
  private readonly down = new Map<string, KeyBinding>();

  constructor(private readonly send: (intent: Intent) => void) {}

  /** Whether this was news: a repeat of a key that is down is none. */
  press(name: string, binding: KeyBinding): boolean {
    if (this.down.has(name)) return false;
    this.down.set(name, binding);
    onDown(binding).forEach(this.send);
    return true;
  }

  release(name: string): boolean {
    const binding = this.down.get(name);
    if (!binding) return false;
    this.down.delete(name);
    onUp(binding).forEach(this.send);
    return true;
  }

  /** The page lost the keyboard: nothing stays held. */
  releaseAll(): void {
    for (const name of [...this.down.keys()]) this.release(name);
  }

  has(name: string): boolean {
    return this.down.has(name);
  }
}
