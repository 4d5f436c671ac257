/** Shows the version, the last edit and the number of findings above the table; buttons to undo and redo. */

import { signal } from "@preact/signals-core";
import { html } from "lit-html";
import { reasonOf } from "../../net/reason";
import type { Drawer } from "../../state/inspection";
import { draw } from "../../ui/draw";
import { icon } from "../../ui/icons";
import type { App } from "../../view/app";
import { countWords } from "./findings";

const KEPT = "edits are kept";
/** What the button shows in place of these words. */
const SIGNS: Record<string, string> = { "nothing is wrong": "✓", "not known yet": "…" };

/** Says how the newest version came about, or which edits the server has not answered. */
function editWords({ machine, editing }: App): string {
  const info = machine.info.value;
  const [newest, waiting] = [editing.newest.value, editing.queue.waiting.value.length];
  if (editing.queue.away.value)
    return `the server does not answer: ${waiting} ${waiting > 1 ? "edits wait" : "edit waits"} here for it`;
  if (!info) return "";
  const kept = info.saved === "file" ? "in machine.yaml" : "by the server, not in its file";
  const edited = info.version > 1 && newest?.version === info.version;
  return edited ? `${newest.what}, kept ${kept}` : `${KEPT} ${kept}`;
}

export function versionBar(host: HTMLElement, app: App, showFindings: () => void): void {
  const { editing, machine, inspection } = app;
  const measuring = signal(false);
  const [undoIcon, redoIcon] = [icon("undo"), icon("redo")];

  async function measure(): Promise<void> {
    measuring.value = true;
    app.notices.emit(await editing.measure().catch(reasonOf));
    measuring.value = false;
  }

  const toggle = (part: Drawer): void => {
    inspection.drawer.value = inspection.drawer.value === part ? null : part;
  };

  draw(host, () => {
    const info = machine.info.value;
    const findings = countWords(editing.verified.value);
    const words = editWords(app);
    const isNews = words !== "" && !words.startsWith(KEPT);
    return html`<b class="version" .textContent=${info ? `v${info.version}` : ""}></b>
      <span class="what" role="status" data-news=${isNews} title=${words} .textContent=${words}></span>
      <button
        type="button"
        class="plain count"
        title="what the verifier says of the table"
        aria-label=${`findings: ${findings}`}
        .textContent=${SIGNS[findings] ?? findings}
        @click=${showFindings}
      ></button>
      <button
        type="button"
        class="plain measure"
        title="play every transition, and measure it: feet, knees, hands, jumps"
        ?disabled=${measuring.value}
        .textContent=${measuring.value ? "measuring …" : "measure"}
        @click=${() => void measure()}
      ></button>
      <button
        type="button"
        class="plain undo"
        aria-label="undo"
        title="undo: the version before (Ctrl+Z)"
        ?disabled=${!info?.undo}
        @click=${() => void editing.undo()}
      >
        ${undoIcon}
      </button>
      <button
        type="button"
        class="plain redo"
        aria-label="redo"
        title="redo: take the undo back (Ctrl+Shift+Z)"
        ?disabled=${!info?.redo}
        @click=${() => void editing.redo()}
      >
        ${redoIcon}
      </button>
      <button
        type="button"
        class="plain"
        title="the selected cell or state, field by field (Alt+Enter)"
        aria-expanded=${inspection.drawer.value === "cell"}
        @click=${() => toggle("cell")}
      >
        inspect
      </button>
      <button
        type="button"
        class="plain"
        title="all versions, and what each changed"
        aria-expanded=${inspection.drawer.value === "versions"}
        @click=${() => toggle("versions")}
      >
        versions
      </button>`;
  });
  window.addEventListener("keydown", (press) => pressed(press, app));
  app.commands.add(
    { keys: [], words: "undo: the version before", act: () => void step(app, false) },
    { keys: [], words: "redo: take the undo back", act: () => void step(app, true) },
    { keys: [], words: "findings of the verifier", act: showFindings },
    { keys: [], words: "measure every transition", act: () => void measure() },
  );
}

/** Undoes by Ctrl+Z, redoes by Ctrl+Shift+Z or Ctrl+Y; text fields have their own undo. */
function pressed(press: KeyboardEvent, app: App): void {
  const key = press.key.toLowerCase();
  if (isTyping(press.composedPath()[0]) || !(press.ctrlKey || press.metaKey) || (key !== "z" && key !== "y"))
    return;
  if (step(app, press.shiftKey || key === "y")) press.preventDefault();
}

/** Undoes, or redoes (`again`); returns whether there is something to. */
function step({ machine, editing }: App, again: boolean): boolean {
  const { undo, redo } = machine.info.value ?? { undo: 0, redo: 0 };
  if (!(again ? redo : undo)) return false;
  void (again ? editing.redo() : editing.undo());
  return true;
}

function isTyping(target: EventTarget | undefined): boolean {
  if (target instanceof HTMLInputElement) return !["range", "checkbox", "radio"].includes(target.type);
  return target instanceof HTMLTextAreaElement || (target instanceof HTMLElement && target.isContentEditable);
}
