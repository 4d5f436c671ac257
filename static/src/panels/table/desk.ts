/** Below the table: what the cell says that is edited, and what the verifier thinks of what is typed; or of the table as it is. */

import type { Answer, Editing } from "../../editing";
import type { Cell, Finding } from "../../net/protocol";
import { el, say } from "../dom";
import { cellSentence } from "./celltext";
import { countWords, findingItems, marked, mended } from "./findings";

export class Desk {
  private readonly verdict = el("p", { class: "trial", role: "status" });
  private readonly cell = el("p", { class: "cell-says" });
  /** What one may go on typing. */
  readonly suggestions = el("ul", { class: "suggestions", role: "listbox", id: "suggestions", "aria-label": "completions" });
  private readonly list = el("ul", { class: "findings" });
  private editing_ = false;
  private stays = "";

  constructor(
    private readonly host: HTMLElement,
    private readonly editing: Editing,
    private readonly go: (finding: Finding) => void,
  ) {
    host.append(this.suggestions, this.cell, this.verdict, this.list);
    host.hidden = true;
    editing.findings.on(() => !this.editing_ && !host.hidden && this.list_(editing.findings.value));
  }

  begin(state: string, event: string, cell: Cell | null | undefined): void {
    this.editing_ = true;
    this.stays = "";
    this.host.hidden = false;
    this.host.dataset["trial"] = "";
    say(this.cell, cellSentence(state, event, cell));
    this.cell.hidden = false;
    this.unchanged();
  }

  /** Nothing is typed that was not there. */
  unchanged(): void {
    this.host.dataset["trial"] = "";
    say(this.verdict, this.stays || "STATE, STATE!, STATE at end, STATE at MARKER, - or nothing");
    this.list_(this.editing.findings.value);
  }

  trying(): void {
    this.host.dataset["trial"] = "trying";
  }

  show({ kind, words, findings }: Answer): void {
    const before = this.editing.findings.value;
    this.host.dataset["trial"] = kind;
    if (kind === "stale") this.stays = `Somebody else has edited: ${words}. What you typed is still here; Enter keeps it on top.`;
    if (kind === "stale") return say(this.verdict, this.stays);
    if (kind === "refused") {
      say(this.verdict, "Refused: this cannot be kept.");
      return this.list_([...findings, ...(findings.length ? [] : [{ kind, severity: "error" as const, message: words, line: 0 }])], []);
    }
    const added = marked(before, findings).filter(({ isNew, severity }) => isNew && severity !== "info").length;
    const gone = mended(before, findings);
    const news = [added ? `${added} new below` : "", gone ? `${gone} mended` : ""].filter(Boolean).join(", ");
    say(this.verdict, `${this.stays ? `${this.stays} ` : ""}Enter keeps it, Escape drops it${news ? ` (${news})` : ": nothing new is wrong"}.`);
    this.list_(findings);
  }

  end(): void {
    this.editing_ = false;
    this.host.hidden = true;
  }

  /** Shows what is wrong with the table as it is, or hides it. */
  toggle(): void {
    if (this.editing_) return;
    this.host.hidden = !this.host.hidden;
    this.cell.hidden = true;
    this.host.dataset["trial"] = "";
    say(this.verdict, countWords(this.editing.findings.value));
    this.list_(this.editing.findings.value);
  }

  private list_(findings: readonly Finding[], before: readonly Finding[] = this.editing.findings.value): void {
    this.list.replaceChildren(...findingItems(marked(before, findings), this.go));
  }
}
