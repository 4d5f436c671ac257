/**
 * Shows, below the table, the edited cell in words and the verifier's findings about the typed text, or about
 * the table.
 */

import { effect, signal } from "@preact/signals-core";
import { html, type TemplateResult } from "lit-html";
import type { Answer } from "../../state/editAnswer";
import type { Editing } from "../../state/editing";
import type { Cell, Finding } from "../../net/protocol";
import { el } from "../../ui/dom";
import { draw } from "../../ui/draw";
import { cellSentence } from "./cellText";
import { countWords, findingItems, fixed, marked } from "./findings";

const HOW = "STATE, STATE!, STATE at end, STATE at MARKER, - or nothing";
const AWAY = "The server does not answer. Enter sends this text as soon as it does.";
const REFUSED = "Refused: you cannot keep this text.";

/** What is shown about the edited cell. */
interface Trial {
  /** The cell in words. */
  cell: string;
  kind: "" | "trying" | Answer["kind"];
  words: string;
  /** About the typed text; null: those of the table. */
  findings: readonly Finding[] | null;
}

/** Says what a text that may be kept changes about the findings `before`; null: they are not known yet. */
export function fineWords(before: readonly Finding[] | null, now: readonly Finding[]): string {
  if (!before) return "Enter keeps it, Escape drops it.";
  const added = marked(before, now).filter(({ isNew, severity }) => isNew && severity !== "info").length;
  const gone = fixed(before, now);
  const news = [added ? `${added} new below` : "", gone ? `${gone} fixed` : ""].filter(Boolean).join(", ");
  return `Enter keeps it, Escape drops it${news ? ` (${news})` : ": nothing new is wrong"}.`;
}

/** Returns the findings of a refusal; without any, one with the server's words. */
function reasons({ kind, words, findings }: Answer): readonly Finding[] {
  if (findings.length) return findings;
  const nowhere = { line: 0, layer: "", state: null, event: null, replay: [], ticks: 0 };
  return [{ kind, severity: "error", message: words, subject: words, ...nowhere }];
}

export class TrialReport {
  /** The completions, shown by the cell editor. */
  readonly suggestions = el("ul", {
    class: "suggestions",
    role: "listbox",
    id: "suggestions",
    "aria-label": "completions",
  });
  /** Null: no cell is edited. */
  private readonly trial = signal<Trial | null>(null);
  /** Whether the findings about the table are shown while no cell is edited. */
  private readonly isOpen = signal(false);
  /** Stays before all words until the editor is closed. */
  private stays = "";

  constructor(
    private readonly host: HTMLElement,
    private readonly editing: Editing,
    private readonly go: (finding: Finding) => void,
    private readonly inspect: () => void,
  ) {
    effect(() => {
      host.hidden = !this.trial.value && !this.isOpen.value;
      host.dataset["trial"] = this.trial.value?.kind ?? "";
    });
    host.tabIndex = 0; // it scrolls
    draw(host, () => this.template());
  }

  holds(target: EventTarget | null): boolean {
    return target instanceof Node && this.host.contains(target);
  }

  /** Tells when the focus leaves the report, and when Escape is pressed in it. */
  whenLeft(left: (to: EventTarget | null) => void, dropped: () => void): void {
    this.host.addEventListener("focusout", ({ relatedTarget }) => left(relatedTarget));
    this.host.addEventListener("keydown", (press) => {
      if (press.key !== "Escape") return;
      press.stopPropagation();
      dropped();
    });
  }

  begin(state: string, event: string, cell: Cell | undefined): void {
    this.stays = "";
    this.trial.value = { cell: cellSentence(state, event, cell), kind: "", words: HOW, findings: null };
  }

  /** Shows the state before anything is typed. */
  unchanged(): void {
    this.change({ kind: "", words: this.stays || HOW, findings: null });
  }

  /** The server did not answer: it has refused nothing. */
  unheard(): void {
    this.change({ kind: "", words: AWAY, findings: null });
  }

  trying(): void {
    this.change({ kind: "trying" });
  }

  show(answer: Answer): void {
    const { kind, words, findings } = answer;
    if (kind === "stale") {
      this.stays = `Another editor was faster: ${words}. Your text is still here; Enter keeps it on top.`;
      this.change({ kind, words: this.stays });
    } else if (kind === "refused") this.change({ kind, words: REFUSED, findings: reasons(answer) });
    else {
      const news = fineWords(this.editing.verified.value, findings);
      this.change({ kind, words: [this.stays, news].filter(Boolean).join(" "), findings });
    }
  }

  end(): void {
    this.trial.value = null;
    this.isOpen.value = false;
  }

  /** Shows the findings about the table, and takes the focus, so that Escape hides them; or hides them. */
  toggle(): void {
    if (this.trial.value) return;
    this.isOpen.value = !this.isOpen.value;
    if (this.isOpen.value) this.host.focus({ preventScroll: true });
  }

  private change(part: Partial<Trial>): void {
    if (this.trial.value) this.trial.value = { ...this.trial.value, ...part };
  }

  private template(): TemplateResult {
    const trial = this.trial.value;
    const table = this.editing.verified.value;
    const shown = trial?.findings ?? table ?? [];
    // Everything about a refused text is new.
    const before = trial?.kind === "refused" ? [] : (table ?? shown);
    return html`${this.suggestions}
      <p class="cell-says" ?hidden=${!trial}>
        <span .textContent=${trial?.cell ?? ""}></span>
        <button type="button" title="the cell, field by field" @click=${this.inspect}>inspect</button>
      </p>
      <p class="trial" role="status" .textContent=${trial?.words ?? countWords(table)}></p>
      <ul class="findings">
        ${findingItems(marked(before, shown), this.go)}
      </ul>`;
  }
}
