/** The page's commands: one list for the keys, the palette and the help. */

import { computed, signal } from "@preact/signals-core";
import { cap } from "./keyBindings";
import { keptKeys, keepKeys } from "./keptKeys";

export interface Command {
  /** What it does, in the palette and the help; no other command has these words. */
  words: string;
  /** Its keys until the user changes them: `f`, `ctrl+k`; a command may have none. */
  keys: readonly string[];
  act: () => void;
}

/** Keys that move the focus, or act in the focused element. */
const RESERVED = ["Tab", "Escape", "Enter", " ", "Shift", "Control", "Alt", "AltGraph", "Meta"];

/** Returns the name of a pressed key in the list of commands. */
export function keyName({
  key,
  ctrlKey,
  metaKey,
}: Pick<KeyboardEvent, "key" | "ctrlKey" | "metaKey">): string {
  return (ctrlKey || metaKey ? "ctrl+" : "") + (key.length === 1 ? key.toLowerCase() : key);
}

/** Returns the label of a key in the list of commands. */
export function keyCap(key: string): string {
  return key.startsWith("ctrl+") ? `ctrl ${cap(key.slice("ctrl+".length))}` : cap(key);
}

export class Commands {
  private readonly added = signal<readonly Command[]>([]);
  /** By the command's words: the keys that the user gave it. */
  private readonly changed = signal(keptKeys());
  /** All commands, with the user's keys. */
  readonly all = computed(() =>
    this.added.value.map((command) => ({
      ...command,
      keys: this.changed.value[command.words] ?? command.keys,
    })),
  );
  readonly areChanged = computed(() => Object.keys(this.changed.value).length > 0);

  add(...more: Command[]): void {
    this.added.value = [...this.added.value, ...more];
  }

  /** Returns the command of a key. */
  of(key: string): Command | undefined {
    return this.all.value.find(({ keys }) => keys.includes(key));
  }

  /** Gives a command one key instead of its keys; returns why not, or null. */
  rebind(words: string, key: string): string | null {
    const owner = this.of(key);
    if (RESERVED.includes(key.replace("ctrl+", ""))) return `${keyCap(key)} can't be a command's key`;
    if (owner && owner.words !== words) return `${keyCap(key)} is already the key of “${owner.words}”`;
    this.keep({ ...this.changed.value, [words]: [key] });
    return null;
  }

  /** Gives every command its first keys again. */
  reset(): void {
    this.keep({});
  }

  private keep(keys: Record<string, readonly string[]>): void {
    this.changed.value = keys;
    keepKeys(keys);
  }
}
