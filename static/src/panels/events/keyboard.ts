/** Listens to the keyboard: the machine's keys first, then the page's commands. */

import { keyName } from "../../state/commands";
import { HeldKeys, bindingOf, mainEvent } from "../../state/keyBindings";
import type { App } from "../../view/app";

/** Returns whether the focused element uses this key itself. */
function wanted(target: EventTarget | null, key: string): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target.closest("dialog[open]")) return true;
  if (target instanceof HTMLSelectElement || target instanceof HTMLInputElement)
    return /^(Arrow|Page|Home$|End$| $)/.test(key);
  return target instanceof HTMLButtonElement && (key === " " || key === "Enter");
}

export class Keyboard {
  private readonly held: HeldKeys;

  constructor(
    private readonly app: App,
    private readonly shown: (event: string, down: boolean) => void,
  ) {
    this.held = new HeldKeys(() => app.session.inputs.sender());
    window.addEventListener("keydown", (press) => this.down(press));
    window.addEventListener("keyup", (press) => this.up(press));
    for (const end of ["blur", "pagehide"]) window.addEventListener(end, () => this.letGo());
    document.addEventListener("visibilitychange", () => document.hidden && this.letGo());
    app.selection.actor.subscribe(() => this.letGo());
    app.session.leaving.on(() => this.letGo());
  }

  private down(press: KeyboardEvent): void {
    if (press.altKey || wanted(press.target, press.key)) return;
    if (press.ctrlKey || press.metaKey) return this.command(press);
    const keys = this.app.machine.info.value?.keys ?? {};
    const name = bindingOf(keys, press.key, press.code);
    if (name !== null) {
      press.preventDefault();
      if (this.app.keyChanges.press(name, keys[name]!)) return;
      this.held.press(name, keys[name]!);
      this.show(name, true);
      return;
    }
    this.command(press);
  }

  private command(press: KeyboardEvent): void {
    const command = press.repeat ? undefined : this.app.commands.of(keyName(press));
    if (command) press.preventDefault();
    command?.act();
  }

  private up(press: KeyboardEvent): void {
    const name = bindingOf(this.app.machine.info.value?.keys ?? {}, press.key, press.code);
    if (name === null) return;
    this.app.keyChanges.release(name);
    if (this.held.release(name)) this.show(name, false);
  }

  private show(name: string, down: boolean): void {
    const binding = this.app.machine.info.value?.keys[name];
    const event = binding ? mainEvent(binding) : null;
    if (event !== null) this.shown(event, down);
  }

  private letGo(): void {
    for (const name of Object.keys(this.app.machine.info.value?.keys ?? {}))
      if (this.held.has(name)) this.show(name, false);
    this.held.releaseAll();
    this.app.keyChanges.releaseAll();
  }
}
