/** The list of texts below a field that one may choose from. */

import { el } from "../dom";

export class Suggestions {
  readonly list = el("ul", { class: "suggestions", role: "listbox", id: "suggestions", "aria-label": "completions", hidden: true });
  private texts: readonly string[] = [];
  private chosen = -1;

  constructor(private readonly take: (text: string) => void) {
    document.body.append(this.list);
    // The field keeps the keyboard.
    this.list.addEventListener("pointerdown", (press) => {
      press.preventDefault();
      const item = press.target instanceof Element ? press.target.closest("li") : null;
      if (item) this.take(item.textContent ?? "");
    });
  }

  /** Shows `texts` below `field`, or above it where there is no room. */
  show(texts: readonly string[], field: HTMLElement): void {
    this.texts = texts;
    this.chosen = -1;
    this.list.hidden = texts.length === 0;
    this.list.replaceChildren(...texts.map((text) => el("li", { role: "option" }, text)));
    const box = field.getBoundingClientRect();
    const height = this.list.offsetHeight;
    const above = box.bottom + height > window.innerHeight && box.top > height;
    this.list.style.left = `${Math.min(box.left, window.innerWidth - this.list.offsetWidth - 8)}px`;
    this.list.style.top = `${above ? box.top - height - 2 : box.bottom + 2}px`;
  }

  hide(): void {
    this.texts = [];
    this.list.hidden = true;
  }

  get open(): boolean {
    return this.texts.length > 0;
  }

  /** Goes `by` items on; gives the text that is chosen then. */
  step(by: 1 | -1): string | null {
    if (!this.open) return null;
    this.chosen = (this.chosen + by + this.texts.length + (this.chosen < 0 && by < 0 ? 1 : 0)) % this.texts.length;
    [...this.list.children].forEach((item, i) => item.setAttribute("aria-selected", String(i === this.chosen)));
    return this.texts[this.chosen] ?? null;
  }

  /** The text that Tab takes: the chosen one, else the first. */
  get first(): string | null {
    return this.texts[Math.max(0, this.chosen)] ?? null;
  }
}
