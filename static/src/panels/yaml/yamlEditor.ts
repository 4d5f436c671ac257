/** CodeMirror with YAML and marks at the lines of findings. Loaded when the text is opened. */

import { defaultKeymap, history, historyKeymap } from "@codemirror/commands";
import { yaml } from "@codemirror/lang-yaml";
import { HighlightStyle, syntaxHighlighting } from "@codemirror/language";
import { type Diagnostic, lintGutter, lintKeymap, setDiagnostics } from "@codemirror/lint";
import { Annotation, EditorState } from "@codemirror/state";
import { drawSelection, EditorView, highlightActiveLine, keymap, lineNumbers } from "@codemirror/view";
import { tags } from "@lezer/highlight";
import type { Finding } from "../../net/protocol";
import { changeOf } from "./changeOf";

/** Marks a change that comes from the server, not from typing. */
const SHOWN = Annotation.define<boolean>();

const colours = HighlightStyle.define([
  { tag: tags.comment, color: "var(--ink-3)" },
  { tag: [tags.propertyName, tags.definition(tags.propertyName)], color: "var(--ink)", fontWeight: "600" },
  { tag: [tags.string, tags.content, tags.number, tags.atom], color: "var(--ink-2)" },
  { tag: [tags.punctuation, tags.separator, tags.bracket], color: "var(--ink-3)" },
]);

const look = EditorView.theme({
  "&": { height: "100%", fontSize: "12px", color: "var(--ink)", backgroundColor: "var(--paper)" },
  ".cm-scroller": { fontFamily: "var(--mono)", lineHeight: "1.5" },
  ".cm-gutters": { backgroundColor: "var(--panel)", color: "var(--ink-3)", border: "0" },
  ".cm-activeLine": { backgroundColor: "var(--accent-soft)" },
  ".cm-content": { caretColor: "var(--accent)" },
  ".cm-cursor": { borderLeftColor: "var(--accent)" },
  ".cm-tooltip": { backgroundColor: "var(--raise)", color: "var(--ink)", border: "1px solid var(--edge)" },
  "&.cm-focused": { outline: "2px solid var(--accent)", outlineOffset: "-2px" },
});

export class YamlEditor {
  private readonly view: EditorView;

  constructor(host: HTMLElement, told: { typed: () => void; keep: () => void }) {
    // A style sheet of a shadow tree is allowed by the page's policy, a style element is not.
    const root = host.attachShadow({ mode: "open" });
    const keep = (): boolean => {
      told.keep();
      return true;
    };
    this.view = new EditorView({
      root,
      parent: root,
      state: EditorState.create({
        extensions: [
          lineNumbers(),
          lintGutter(),
          history(),
          drawSelection(),
          highlightActiveLine(),
          yaml(),
          syntaxHighlighting(colours),
          keymap.of([{ key: "Mod-s", run: keep }, ...defaultKeymap, ...historyKeymap, ...lintKeymap]),
          EditorView.contentAttributes.of({ "aria-label": "machine.yaml", tabindex: "0" }),
          EditorView.updateListener.of((update) => {
            const shown = update.transactions.some((transaction) => transaction.annotation(SHOWN));
            if (update.docChanged && !shown) told.typed();
          }),
          look,
        ],
      }),
    });
  }

  get text(): string {
    return this.view.state.doc.toString();
  }

  /** Shows another text: only what differs changes, so that the cursor stays where it is. */
  show(text: string): void {
    const changes = changeOf(this.text, text);
    if (changes) this.view.dispatch({ changes, annotations: SHOWN.of(true) });
  }

  /** Puts the cursor into a line, 1 is the first, and brings it into sight. */
  go(line: number): void {
    const { doc } = this.view.state;
    const anchor = doc.line(Math.min(line, doc.lines)).from;
    this.view.dispatch({
      selection: { anchor },
      effects: EditorView.scrollIntoView(anchor, { y: "center" }),
    });
    this.view.focus();
  }

  /** Marks the lines of findings. */
  mark(findings: readonly Finding[]): void {
    const { doc } = this.view.state;
    const marks = findings
      .filter(({ line }) => line > 0 && line <= doc.lines)
      .map(({ line, severity, message }): Diagnostic => {
        const { from, to } = doc.line(line);
        return { from, to, severity, message };
      });
    this.view.dispatch(setDiagnostics(this.view.state, marks));
  }
}
