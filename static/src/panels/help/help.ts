/** The help dialog: the machine's keys, the viewer's shortcuts, the pointer's gestures. */

import "./help.css";
import { bindingOf, cap, onDown, onUp } from "../../state/keyBindings";
import { keyCap } from "../../state/commands";
import { changedBy } from "../../state/keyChanges";
import type { KeyBinding } from "../../net/protocol";
import type { App } from "../../view/app";
import { el } from "../../ui/dom";

/** Describes a key binding. */
export function bindingWords(binding: KeyBinding): string {
  const down = onDown(binding).map(({ kind, event }) => (kind === "hold" ? `holds ${event}` : event));
  const up = onUp(binding)
    .filter(({ kind }) => kind === "press")
    .map(({ event }) => event);
  const changed = changedBy(binding);
  return [
    down.join(", "),
    up.length ? `released: ${up.join(", ")}` : "",
    changed.length ? `changes ${changed.join(", ")}` : "",
  ]
    .filter(Boolean)
    .join(" · ");
}

function row(keys: string[], text: string): HTMLElement {
  return el(
    "div",
    { class: "help-row" },
    el("dt", {}, ...keys.map((key) => el("kbd", {}, key))),
    el("dd", {}, text),
  );
}

const POINTER: [string, string][] = [
  ["drag", "turn around the character"],
  ["right drag", "move sideways and up"],
  ["wheel", "nearer, farther"],
  ["cell", "edit it: STATE, STATE!, -, STATE at end"],
  ["state, twice", "travel there by the fastest events"],
  ["timeline", "drag: the past; click: why?"],
];

class HelpDialog {
  private readonly dialog = el("dialog", { class: "help", "aria-label": "keys", tabindex: -1 });

  constructor(private readonly app: App) {
    document.body.append(this.dialog);
    app.machine.info.subscribe(() => this.dialog.open && this.fill());
    this.dialog.addEventListener("click", (click) => click.target === this.dialog && this.dialog.close());
  }

  toggle(): void {
    if (this.dialog.open) return this.dialog.close();
    this.fill();
    this.dialog.showModal();
    this.dialog.focus();
  }

  private fill(): void {
    const machine = this.app.machine.info.value;
    const keys = Object.entries(machine?.keys ?? {}).map(([key, binding]) =>
      row([cap(key)], bindingWords(binding)),
    );
    const close = el("button", { type: "button", class: "plain close", "aria-label": "esc: close" }, "esc");
    close.addEventListener("click", () => this.dialog.close());
    const section = (title: string, rows: HTMLElement[]): HTMLElement =>
      el("section", {}, el("h2", {}, title), el("dl", {}, ...rows));
    // A key of the machine comes before the same key of the viewer.
    const own = this.app.commands.all.value.flatMap(({ keys, words }) => {
      const free = keys.filter((key) => bindingOf(machine?.keys ?? {}, key, key) === null);
      return free.length ? [row(free.map(keyCap), words)] : [];
    });
    const pointer = POINTER.map(([how, words]) => row([how], words));
    const title = machine?.title ?? machine?.name ?? "machine";
    const about = machine?.description ? el("p", { class: "about" }, machine.description) : null;
    const sections = el(
      "div",
      { class: "help-columns" },
      section(title, keys),
      section("viewer", own),
      section("pointer", pointer),
    );
    this.dialog.replaceChildren(...[close, about, sections].filter((part) => part !== null));
  }
}

/** The button `host` opens the dialog, as the key `?` does. */
export function helpPanel(host: HTMLElement, app: App): void {
  const dialog = new HelpDialog(app);
  app.commands.add({ keys: ["?"], words: "this help", act: () => dialog.toggle() });
  host.addEventListener("click", () => dialog.toggle());
}
