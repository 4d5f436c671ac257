/**
 * The machine's file beside its table: what is typed is tried at once, and kept as soon as you pause and nothing is
 * wrong, by Ctrl+S, or when you leave it.
 */

import "./yaml.css";
import { effect, signal } from "@preact/signals-core";
import { html, nothing } from "lit-html";
import type { Finding } from "../../net/protocol";
import { reasonOf } from "../../net/reason";
import type { Answer } from "../../state/editAnswer";
import { el } from "../../ui/dom";
import { draw } from "../../ui/draw";
import type { App } from "../../view/app";
import type { YamlEditor } from "./yamlEditor";

const TRIAL_PAUSE_MS = 300;
/** How long typing has to pause, after a trial that found no error, until the text is kept. */
const KEEP_PAUSE_MS = 700;

export function yamlPanel(host: HTMLElement, app: App): void {
  const [bar, place] = [el("div", { class: "yaml-bar" }), el("div", { class: "yaml-editor" })];
  host.append(bar, place);
  const words = signal("");
  const stale = signal(false);
  let editor: YamlEditor | null = null;
  let loading = false;
  let timer: ReturnType<typeof setTimeout> | undefined;
  /** What the text in the editor was made from. */
  let base = { name: "", version: 0, text: "" };
  /** The text that was sent last, to be kept: what is typed meanwhile goes on from it. */
  let sent = "";

  const isDirty = (): boolean => editor !== null && editor.text !== base.text;

  function show(): void {
    const info = app.machine.info.value;
    if (!editor || !info) return;
    if (info.name === base.name && isDirty()) {
      if (![base.text, sent, editor.text].includes(info.text)) stale.value = true;
      else base = { name: info.name, version: info.version, text: info.text };
      return;
    }
    base = { name: info.name, version: info.version, text: info.text };
    stale.value = false;
    editor.show(info.text);
    tell(app.editing.findings.value, "");
  }

  function showLine(line: number | null): void {
    if (!editor || line === null) return;
    app.inspection.fileLine.value = null;
    editor.go(line);
  }

  function tell(findings: readonly Finding[], said: string): void {
    editor?.mark(findings);
    words.value = said;
  }

  function answered(answer: Answer, kept: boolean): void {
    if (answer.kind === "stale") stale.value = true;
    const first = answer.findings[0];
    const refused = first?.line ? `line ${first.line}: ${first.message}` : (first?.message ?? answer.words);
    tell(answer.findings, answer.kind === "refused" ? refused : kept ? "kept" : "");
    if (answer.kind === "fine" && !kept && !stale.value) after(KEEP_PAUSE_MS, false);
  }

  async function send(dry: boolean): Promise<void> {
    clearTimeout(timer);
    if (!editor) return;
    if (!isDirty()) {
      tell(app.editing.findings.value, "");
      return;
    }
    const { text } = editor;
    if (!dry) sent = text;
    const answer = await app.editing
      .text(text, base.version, dry)
      .catch((error: unknown): Answer => ({ kind: "refused", words: reasonOf(error), findings: [] }));
    const isOld = dry && editor.text !== text;
    if (answer && !isOld) answered(answer, !dry);
  }

  function after(pause: number, dry: boolean): void {
    clearTimeout(timer);
    timer = setTimeout(() => void send(dry), pause);
  }

  /** Drops what is typed for the newest text, or (`mine`) puts it in place of that. */
  function settle(mine: boolean): void {
    const info = app.machine.info.value;
    if (!info) return;
    stale.value = false;
    base = { name: info.name, version: info.version, text: info.text };
    if (mine) void send(false);
    else editor?.show(info.text);
  }

  async function load(): Promise<void> {
    loading = true;
    const { YamlEditor } = await import("./yamlEditor");
    editor = new YamlEditor(place, {
      typed: () => after(TRIAL_PAUSE_MS, true),
      keep: () => void send(false),
    });
    show();
    showLine(app.inspection.fileLine.value);
  }

  draw(
    bar,
    () =>
      html`<span role="status" .textContent=${words.value}></span>
        ${
          stale.value
            ? html`<span>The machine has changed meanwhile.</span>
                <button type="button" @click=${() => settle(true)}>keep mine</button>
                <button type="button" @click=${() => settle(false)}>take the newest</button>`
            : nothing
        }
        <button type="button" @click=${() => void send(false)}>keep</button>`,
  );
  effect(() => {
    if (app.inspection.drawer.value === "text" && !loading) void load();
  });
  app.inspection.fileLine.subscribe(showLine);
  app.machine.info.subscribe(() => show());
  app.editing.findings.subscribe((findings) => !isDirty() && editor?.mark(findings));
  place.addEventListener("focusout", (leave) => {
    if (!(leave.relatedTarget instanceof Node && host.contains(leave.relatedTarget))) void send(false);
  });
}
