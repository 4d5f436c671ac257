/** Shows completions in a row: Tab takes the first, the arrow keys choose. */

import { signal } from "@preact/signals-core";
import { html, nothing } from "lit-html";
import { draw } from "../../ui/draw";

export class Suggestions {
  private readonly texts = signal<readonly string[]>([]);
  private readonly chosen = signal(-1);

  constructor(
    private readonly list: HTMLElement,
    field: HTMLElement,
    take: (text: string) => void,
  ) {
    field.setAttribute("aria-controls", list.id);
    // The field keeps the focus.
    list.addEventListener("pointerdown", (press) => press.preventDefault());
    draw(list, () => {
      list.hidden = !this.open;
      field.setAttribute("aria-expanded", String(this.open));
      const isSelected = (i: number): unknown => (this.chosen.value < 0 ? nothing : i === this.chosen.value);
      return html`${this.texts.value.map(
        (text, i) =>
          html`<li role="option" aria-selected=${isSelected(i)} @pointerdown=${() => take(text)}>
            ${text}${i ? nothing : html`<kbd>⇥</kbd>`}
          </li>`,
      )}`;
    });
  }

  show(texts: readonly string[]): void {
    this.chosen.value = -1;
    this.texts.value = texts;
  }

  get open(): boolean {
    return this.texts.value.length > 0;
  }

  /** Chooses the next or previous text and returns it. */
  step(by: 1 | -1): string | null {
    if (!this.open) return null;
    const [count, chosen] = [this.texts.value.length, this.chosen.value];
    this.chosen.value = (chosen + by + count + (chosen < 0 && by < 0 ? 1 : 0)) % count;
    this.list.querySelector("[aria-selected=true]")?.scrollIntoView({ block: "nearest", inline: "nearest" });
    return this.first;
  }

  /** The text that Tab takes: the chosen text, else the first. */
  get first(): string | null {
    return this.texts.value[Math.max(0, this.chosen.value)] ?? null;
  }
}
