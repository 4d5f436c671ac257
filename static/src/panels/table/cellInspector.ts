/**
 * Shows, below the table, the edited cell in words and the verifier's findings about the typed text, or about
 * the table.
 */

import type { Answer, Editing } from "../../state/editing";
import type { Cell, Finding } from "../../net/protocol";
import { el, say } from "../../ui/dom";
import { cellSentence } from "./cellText";
import { countWords, findingItems, marked, fixed } from "./findings";

export class CellInspector {
  private readonly verdict = el("p", { class: "trial", role: "status" });
  private readonly cell = el("p", { class: "cell-says" });
  /** The completions, shown by the cell editor. */
  readonly suggestions = el("ul", {
    class: "suggestions",
    role: "listbox",
    id: "suggestions",
    "aria-label": "completions",
  });
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
    editing.findings.subscribe(() => !this.editing_ && !host.hidden && this.list_(editing.findings.value));
  }

  begin(state: string, event: string, cell: Cell | undefined): void {
    this.editing_ = true;
    this.stays = "";
    this.host.hidden = false;
    this.host.dataset["trial"] = "";
    say(this.cell, cellSentence(state, event, cell));
    this.cell.hidden = false;
    this.unchanged();
  }

  /** Shows the state before anything is typed. */
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
    if (kind === "stale")
      this.stays = `Another editor was faster: ${words}. Your text is still here; Enter keeps it on top.`;
    if (kind === "stale") return say(this.verdict, this.stays);
    if (kind === "refused") {
      say(this.verdict, "Refused: you cannot keep this text.");
      return this.list_(
        [
          ...findings,
          ...(findings.length
            ? []
            : [
                {
                  kind,
                  severity: "error" as const,
                  message: words,
                  line: 0,
                  layer: "",
                  state: null,
                  event: null,
                  replay: [],
                },
              ]),
        ],
        [],
      );
    }
    const added = marked(before, findings).filter(
      ({ isNew, severity }) => isNew && severity !== "info",
    ).length;
    const gone = fixed(before, findings);
    const news = [added ? `${added} new below` : "", gone ? `${gone} fixed` : ""].filter(Boolean).join(", ");
    const stays = this.stays ? `${this.stays} ` : "";
    const result = news ? ` (${news})` : ": nothing new is wrong";
    say(this.verdict, `${stays}Enter keeps it, Escape drops it${result}.`);
    this.list_(findings);
  }

  end(): void {
    this.editing_ = false;
    this.host.hidden = true;
  }

  /** Shows or hides the findings about the table. */
  toggle(): void {
    if (this.editing_) return;
    this.host.hidden = !this.host.hidden;
    this.cell.hidden = true;
    this.host.dataset["trial"] = "";
    say(this.verdict, countWords(this.editing.findings.value));
    this.list_(this.editing.findings.value);
  }

  private list_(
    findings: readonly Finding[],
    before: readonly Finding[] = this.editing.findings.value,
  ): void {
    this.list.replaceChildren(...findingItems(marked(before, findings), this.go));
  }
}
