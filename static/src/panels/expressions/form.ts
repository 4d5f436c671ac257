/** The form in which you edit a machine's expressions; a line that is refused is selected. */

import { signal } from "@preact/signals-core";
import { html, type TemplateResult } from "lit-html";
import type { App } from "../../view/app";
import { fault, lineSpan } from "./lines";

const [FEWEST_ROWS, MOST_ROWS] = [3, 20];

export class ExpressionsForm {
  /** The text that the form began with, or null: the form is closed. */
  private readonly begun = signal<string | null>(null);
  private readonly refused = signal("");

  /** `field` returns the text's field, once `template` is drawn. */
  constructor(
    private readonly app: App,
    private readonly field: () => HTMLTextAreaElement,
  ) {}

  get isOpen(): boolean {
    return this.begun.value !== null;
  }

  open(): void {
    const text = this.app.machine.info.value?.expression_text ?? "";
    this.refused.value = "";
    this.begun.value = text;
    this.field().value = text;
    this.field().focus();
  }

  private close(): void {
    this.begun.value = null;
  }

  private async keep(): Promise<void> {
    const file = this.app.machine.info.value?.text ?? "";
    const text = this.field().value.trim();
    const answer = await this.app.editing.keep([{ kind: "set_expressions", text }]);
    if (answer.kind === "fine") this.close();
    else this.blame(text, fault(answer.words, file));
  }

  /** Says what is wrong, and selects the line. */
  private blame(text: string, { line, words }: ReturnType<typeof fault>): void {
    this.refused.value = words;
    const span = lineSpan(text, line);
    if (!span) return;
    this.field().value = text;
    this.field().focus();
    this.field().setSelectionRange(...span);
  }

  template(): TemplateResult {
    const lines = (this.begun.value ?? "").split("\n").length + 1;
    const submit = (event: Event): void => {
      event.preventDefault();
      void this.keep();
    };
    return html`<form ?hidden=${!this.isOpen} @submit=${submit}>
      <textarea
        spellcheck="false"
        aria-label="expressions"
        rows=${Math.min(MOST_ROWS, Math.max(FEWEST_ROWS, lines))}
        @keydown=${(press: Event) => press.stopPropagation()}
      ></textarea>
      <p class="refused" role="alert" .textContent=${this.refused.value}></p>
      <div>
        <button type="submit">keep</button>
        <button type="button" class="plain" @click=${() => this.close()}>cancel</button>
      </div>
    </form>`;
  }
}
