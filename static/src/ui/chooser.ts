/** Asks for one of several names in a small menu: type to filter, arrow keys and Enter to choose, Escape to drop. */

import "./chooser.css";
import { computed, type Signal, signal } from "@preact/signals-core";
import { html, type TemplateResult } from "lit-html";
import { el } from "./dom";
import { draw } from "./draw";
import { matching, type Named } from "./matching";

/** What the menu offers for a typed name that is not in the list: its words, or null. */
type Novelty = (typed: string) => string | null;

const MARGIN = 8;
/** More hits are no help. */
const MOST_SHOWN = 100;

/** Opens the menu at a place in the window; returns the chosen or new name, or null. */
export function choose(
  title: string,
  choices: readonly Named[],
  at: { x: number; y: number },
  novelty: Novelty = () => null,
): Promise<string | null> {
  return new Promise((done) =>
    new Chooser(title, choices, novelty, (choice) => done(choice?.name ?? null)).open(at),
  );
}

/**
 * Opens a large menu in the middle of the window, at once, so that no typed letter goes elsewhere; `newer` items
 * take the place of `items` when they are known. Returns the chosen item, or null.
 */
export function find<T extends Named>(
  title: string,
  items: readonly T[],
  newer: Promise<readonly T[]>,
): Promise<T | null> {
  return new Promise((done) => {
    let offered = items;
    const end = (choice: Named | null): void => done(offered.find((item) => item === choice) ?? null);
    const chooser = new Chooser(title, items, () => null, end);
    chooser.openWide();
    void newer.then((known) => {
      offered = known;
      chooser.offer(known);
    });
  });
}

class Chooser {
  private readonly dialog: HTMLDialogElement;
  private readonly choices: Signal<readonly Named[]>;
  private readonly typed = signal("");
  private readonly chosen = signal(0);
  private readonly shown = computed(() => this.hits());

  constructor(
    private readonly title: string,
    choices: readonly Named[],
    private readonly novelty: Novelty,
    private readonly done: (choice: Named | null) => void,
  ) {
    this.choices = signal(choices);
    this.dialog = el("dialog", { class: "chooser", "aria-label": title });
    draw(this.dialog, () => this.content());
    this.dialog.addEventListener("keydown", (press) => this.pressed(press));
    this.dialog.addEventListener("keyup", (press) => press.stopPropagation());
    this.dialog.addEventListener("click", ({ target }) => target === this.dialog && this.end(null));
    this.dialog.addEventListener("close", () => this.end(null));
  }

  openWide(): void {
    this.dialog.classList.add("wide");
    this.show();
  }

  open({ x, y }: { x: number; y: number }): void {
    this.show();
    const { width, height } = this.dialog.getBoundingClientRect();
    const within = (value: number, size: number, room: number): number =>
      Math.max(MARGIN, Math.min(value, room - size - MARGIN));
    this.dialog.style.left = `${within(x, width, innerWidth)}px`;
    this.dialog.style.top = `${within(y, height, innerHeight)}px`;
  }

  /** Offers other choices; the marked one stays marked. */
  offer(choices: readonly Named[]): void {
    const marked = this.shown.value[this.chosen.value];
    this.choices.value = choices;
    this.mark(this.shown.value.findIndex(({ name, note }) => name === marked?.name && note === marked.note));
  }

  private show(): void {
    document.body.append(this.dialog);
    this.dialog.showModal();
    this.dialog.querySelector("input")!.focus();
  }

  private end(choice: Named | null): void {
    if (!this.dialog.isConnected) return;
    this.dialog.remove();
    this.done(choice);
  }

  private hits(): readonly Named[] {
    const [typed, choices] = [this.typed.value, this.choices.value];
    const hits = matching(choices, typed).slice(0, MOST_SHOWN);
    const note = typed && !choices.some(({ name }) => name === typed) ? this.novelty(typed) : null;
    return note === null ? hits : [...hits, { name: typed, note }];
  }

  private content(): TemplateResult {
    const [shown, chosen] = [this.shown.value, this.chosen.value];
    const type = ({ target }: Event): void => {
      this.typed.value = (target as HTMLInputElement).value.trim();
      this.mark(0);
    };
    return html`<input
        type="text"
        role="combobox"
        autocomplete="off"
        spellcheck="false"
        maxlength="60"
        placeholder=${this.title}
        aria-label=${this.title}
        aria-controls="choices"
        aria-expanded="true"
        aria-activedescendant=${shown.length ? `choice-${chosen}` : ""}
        @input=${type}
      />
      <ul role="listbox" id="choices" aria-label=${this.title}>
        ${shown.map(
          (choice, i) =>
            html`<li
              role="option"
              id=${`choice-${i}`}
              aria-selected=${i === chosen}
              @click=${() => this.end(choice)}
            >
              <span .textContent=${choice.name}></span>
              <small .textContent=${choice.note}></small>
            </li>`,
        )}
      </ul>`;
  }

  private mark(index: number): void {
    this.chosen.value = Math.min(Math.max(0, index), this.shown.value.length - 1);
    this.dialog.querySelector("[aria-selected=true]")?.scrollIntoView({ block: "nearest" });
  }

  private pressed(press: KeyboardEvent): void {
    press.stopPropagation();
    const step = press.key === "ArrowDown" ? 1 : press.key === "ArrowUp" ? -1 : 0;
    if (step) this.mark(this.chosen.value + step);
    else if (press.key === "Enter") this.end(this.shown.value[this.chosen.value] ?? null);
    else return;
    press.preventDefault();
  }
}
