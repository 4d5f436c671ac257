/** Shows completions in a row: Tab takes the first, the arrow keys choose. */

import { el } from "../../ui/dom";

export class Suggestions {
  private texts: readonly string[] = [];
  private chosen = -1;

  constructor(
    private readonly list: HTMLElement,
    private readonly field: HTMLElement,
    private readonly take: (text: string) => void,
  ) {
    list.hidden = true;
    field.setAttribute("aria-controls", list.id);
    field.setAttribute("aria-expanded", "false");
    // The field keeps the focus.
    list.addEventListener("pointerdown", (press) => {
      press.preventDefault();
      const item = press.target instanceof Element ? press.target.closest("li") : null;
      if (item) this.take(this.texts[[...this.list.children].indexOf(item)] ?? "");
    });
  }

  show(texts: readonly string[]): void {
    this.texts = texts;
    this.chosen = -1;
    this.list.hidden = !this.open;
    this.field.setAttribute("aria-expanded", String(this.open));
    this.list.replaceChildren(
      ...texts.map((text, i) => el("li", { role: "option" }, text, i ? null : el("kbd", {}, "⇥"))),
    );
  }

  get open(): boolean {
    return this.texts.length > 0;
  }

  /** Chooses the next or previous text and returns it. */
  step(by: 1 | -1): string | null {
    if (!this.open) return null;
    this.chosen =
      (this.chosen + by + this.texts.length + (this.chosen < 0 && by < 0 ? 1 : 0)) % this.texts.length;
    [...this.list.children].forEach((item, i) =>
      item.setAttribute("aria-selected", String(i === this.chosen)),
    );
    this.list.children[this.chosen]?.scrollIntoView({ block: "nearest", inline: "nearest" });
    return this.texts[this.chosen] ?? null;
  }

  /** The text that Tab takes: the chosen text, else the first. */
  get first(): string | null {
    return this.texts[Math.max(0, this.chosen)] ?? null;
  }
}
