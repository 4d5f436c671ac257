/** The help dialog: the keys, which the user can change, the marks in cells, the pointer's gestures. */

import "./help.css";
import { signal } from "@preact/signals-core";
import { html, nothing, type TemplateResult } from "lit-html";
import { type Command, keyCap, keyName } from "../../state/commands";
import { bindingOf, cap, onDown, onUp } from "../../state/keyBindings";
import { changedBy } from "../../state/keyChanges";
import type { KeyBinding } from "../../net/protocol";
import type { App } from "../../view/app";
import { closeButton } from "../../ui/closeButton";
import { el } from "../../ui/dom";
import { draw } from "../../ui/draw";
import { FOCUSED, MARKS, POINTER } from "./gestures";

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

const row = (how: readonly string[], words: string): TemplateResult =>
  html`<div class="help-row">
    <dt>${how.map((key) => html`<kbd .textContent=${key}></kbd>`)}</dt>
    <dd .textContent=${words}></dd>
  </div>`;

const section = (title: string, rows: readonly TemplateResult[], more: unknown = nothing): TemplateResult =>
  html`<section>
    <h2 .textContent=${title}></h2>
    <dl>${rows}</dl>
    ${more}
  </section>`;

/** Most commands have no key, and are found by their words. */
const keyedFirst = (all: readonly Command[]): Command[] => [
  ...all.filter(({ keys }) => keys.length),
  ...all.filter(({ keys }) => !keys.length),
];

class HelpDialog {
  private readonly dialog = el("dialog", { class: "help", "aria-label": "keys", tabindex: -1 });
  private readonly open = signal(false);
  /** The words of the command whose next key is awaited, or null. */
  private readonly awaiting = signal<string | null>(null);
  private readonly told = signal("");

  constructor(private readonly app: App) {
    document.body.append(this.dialog);
    draw(this.dialog, () => (this.open.value ? this.content() : html``));
    this.dialog.addEventListener("click", (click) => click.target === this.dialog && this.dialog.close());
    this.dialog.addEventListener("keydown", (press) => this.pressed(press));
    this.dialog.addEventListener("close", () => this.closed());
  }

  toggle(): void {
    if (this.dialog.open) return this.dialog.close();
    this.open.value = true;
    this.dialog.showModal();
    this.dialog.focus();
  }

  private closed(): void {
    this.open.value = false;
    this.awaiting.value = null;
    this.told.value = "";
  }

  /** Takes the awaited key. */
  private pressed(press: KeyboardEvent): void {
    const words = this.awaiting.value;
    if (words === null || ["Shift", "Control", "Alt", "Meta", "Tab"].includes(press.key)) return;
    press.preventDefault();
    if (press.key === "Escape") {
      this.awaiting.value = null;
      return;
    }
    const key = keyName(press);
    this.told.value = this.machines(press) ?? this.app.commands.rebind(words, key) ?? "";
    if (!this.told.value) this.awaiting.value = null;
  }

  /** Says that a key is the machine's, which comes before the page's commands; else null. */
  private machines({ key, code, ctrlKey, metaKey }: KeyboardEvent): string | null {
    const machine = this.app.machine.info.value;
    if (!machine || ctrlKey || metaKey || bindingOf(machine.keys, key, code) === null) return null;
    return `${keyCap(key)} is a key of ${machine.title || machine.name}`;
  }

  private content(): TemplateResult {
    const machine = this.app.machine.info.value;
    const keys = Object.entries(machine?.keys ?? {}).map(([key, binding]) =>
      row([cap(key)], bindingWords(binding)),
    );
    const { all, areChanged } = this.app.commands;
    return html`${closeButton}
      ${machine?.description ? html`<p class="about" .textContent=${machine.description}></p>` : nothing}
      <p class="told" role="status" .textContent=${this.told.value}></p>
      <div class="help-columns">
        ${section(machine?.title ?? machine?.name ?? "machine", keys, this.toMachine())}
        ${section(
          "commands: click to change",
          keyedFirst(all.value).map((command) => this.command(command, machine?.keys ?? {})),
        )}
        ${section(
          "keys where the focus is",
          FOCUSED.map(([key, words]) => row([key], words)),
        )}
        ${section(
          "marks in cells",
          MARKS.map(([mark, words]) => row([mark], words)),
        )}
        ${section(
          "pointer",
          POINTER.map(([how, words]) => row([how], words)),
        )}
      </div>
      <button
        type="button"
        class="reset"
        ?hidden=${!areChanged.value}
        @click=${() => this.app.commands.reset()}
      >
        reset all keys
      </button>`;
  }

  /** The button that leads to the form with the machine's keys. */
  private toMachine(): TemplateResult {
    const change = (): void => {
      this.dialog.close();
      this.app.inspection.drawer.value = "machine";
    };
    return html`<button type="button" class="plain" @click=${change}>change the machine’s keys</button>`;
  }

  /** A key of the machine comes before the same key of a command. */
  private command({ words, keys }: Command, taken: Record<string, KeyBinding>): TemplateResult {
    const free = keys.filter((key) => bindingOf(taken, key, key) === null);
    const awaited = this.awaiting.value === words;
    const label = awaited ? "press a key" : free.map(keyCap).join(" ") || "none";
    const change = (): void => {
      this.told.value = "";
      this.awaiting.value = awaited ? null : words;
    };
    return html`<div class="help-row">
      <dt>
        <button
          type="button"
          class="key"
          aria-label=${`key of “${words}”: ${label}`}
          aria-pressed=${awaited}
          @click=${change}
          .textContent=${label}
        ></button>
      </dt>
      <dd .textContent=${words}></dd>
    </div>`;
  }
}

/** The button `host` opens the dialog, as its key does. */
export function helpPanel(host: HTMLElement, app: App): void {
  const dialog = new HelpDialog(app);
  app.commands.add({ keys: ["?"], words: "this help", act: () => dialog.toggle() });
  host.addEventListener("click", () => dialog.toggle());
}
