/** Asks for one of several names in a small menu: type to filter, arrow keys and Enter to choose, Escape to drop. */

import "./chooser.css";
import { el } from "./dom";
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
  private readonly field = el("input", {
    type: "text",
    role: "combobox",
    autocomplete: "off",
    spellcheck: "false",
    maxlength: 60,
    "aria-controls": "choices",
    "aria-expanded": "true",
  });
  private readonly list = el("ul", { role: "listbox", id: "choices" });
  private readonly dialog: HTMLDialogElement;
  private shown: readonly Named[] = [];
  private chosen = 0;

  constructor(
    title: string,
    private choices: readonly Named[],
    private readonly novelty: Novelty,
    private readonly done: (choice: Named | null) => void,
  ) {
    this.field.setAttribute("aria-label", title);
    this.field.placeholder = title;
    this.list.setAttribute("aria-label", title);
    this.dialog = el("dialog", { class: "chooser", "aria-label": title }, this.field, this.list);
    this.field.addEventListener("input", () => this.draw());
    this.dialog.addEventListener("keydown", (press) => this.pressed(press));
    this.dialog.addEventListener("keyup", (press) => press.stopPropagation());
    this.dialog.addEventListener("click", ({ target }) => this.clicked(target as Element));
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
    const marked = this.shown[this.chosen];
    this.choices = choices;
    this.draw();
    this.mark(this.shown.findIndex(({ name, note }) => name === marked?.name && note === marked.note));
  }

  private show(): void {
    document.body.append(this.dialog);
    this.draw();
    this.dialog.showModal();
    this.field.focus();
  }

  private end(choice: Named | null): void {
    if (!this.dialog.isConnected) return;
    this.dialog.remove();
    this.done(choice);
  }

  private draw(): void {
    const typed = this.field.value.trim();
    const hits = matching(this.choices, typed).slice(0, MOST_SHOWN);
    const known = this.choices.some(({ name }) => name === typed);
    const note = typed && !known ? this.novelty(typed) : null;
    this.shown = note === null ? hits : [...hits, { name: typed, note }];
    this.list.replaceChildren(
      ...this.shown.map(({ name, note: words }, i) =>
        el(
          "li",
          { role: "option", id: `choice-${i}`, "data-index": i },
          el("span", {}, name),
          el("small", {}, words),
        ),
      ),
    );
    this.mark(0);
  }

  private mark(index: number): void {
    this.chosen = Math.min(Math.max(0, index), this.shown.length - 1);
    [...this.list.children].forEach((item, i) =>
      item.setAttribute("aria-selected", String(i === this.chosen)),
    );
    this.list.children[this.chosen]?.scrollIntoView({ block: "nearest" });
    this.field.setAttribute("aria-activedescendant", this.shown.length ? `choice-${this.chosen}` : "");
  }

  private pressed(press: KeyboardEvent): void {
    press.stopPropagation();
    const step = press.key === "ArrowDown" ? 1 : press.key === "ArrowUp" ? -1 : 0;
    if (step) this.mark(this.chosen + step);
    else if (press.key === "Enter") this.end(this.shown[this.chosen] ?? null);
    else return;
    press.preventDefault();
  }

  private clicked(target: Element): void {
    if (target === this.dialog) this.end(null);
    const item = target.closest<HTMLElement>("[data-index]");
    if (item) this.end(this.shown[Number(item.dataset["index"])]!);
  }
}
