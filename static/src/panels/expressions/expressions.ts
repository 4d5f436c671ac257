/**
 * Lists the expressions of the watched actor's machine and character, and of the states that it is in: which line sets
 * what, and its present value. The machine's own lines are edited here.
 */

import "./expressions.css";
import { actorFacts } from "../../net/actors";
import { ApiError } from "../../net/api";
import type { ActorView, ExpressionView } from "../../net/types/api.generated";
import type { MachineInfo } from "../../net/protocol";
import type { App } from "../../view/app";
import { el, say } from "../../ui/dom";

const READ_MS = 500;
const KEY = "expressions:";
/** More lines than this are folded. */
const MANY = 12;

/** Splits a line at its first equals sign. */
export function sides(line: string): [string, string] {
  const at = line.indexOf("=");
  return [line.slice(0, at).trim(), line.slice(at + 1).trim()];
}

/** Writes a value with at most four digits after the point. */
export function rounded(value: number): string {
  return String(Number(value.toFixed(4)));
}

/** Returns the present value of a line: a channel's or a variable's. */
export function valueOf(line: ExpressionView, facts: ActorView | null): string {
  const value = facts?.channels[line.name] ?? facts?.variables[line.name];
  return value === undefined ? "" : rounded(value);
}

/** Says what is wrong by the line of the text that is edited, not of the machine file `file`. */
export function fault(words: string, file: string): { line: number; words: string } {
  const found = /^[^:]*\bline (\d+): (.*)/s.exec(words);
  const lines = file.trimEnd().split("\n");
  const key = lines.findIndex((line) => line.startsWith(KEY));
  const line = Number(found?.[1] ?? 0) - (key < 0 ? lines.length : key) - 1;
  if (!found || line < 1) return { line: 0, words };
  return { line, words: `line ${line}: ${found[2] ?? ""}` };
}

class ExpressionsPanel {
  private readonly values = new Map<ExpressionView, HTMLElement>();
  private readonly list = el("div", {});
  private readonly text = el("textarea", { spellcheck: "false", "aria-label": "expressions" });
  private readonly refused = el("p", { class: "refused", role: "alert" });
  private readonly form = el("form", { hidden: true });
  private readonly edit = el("button", { type: "button", class: "plain" }, "edit");

  constructor(
    private readonly host: HTMLElement,
    private readonly app: App,
  ) {
    const keep = el("button", { type: "submit" }, "keep");
    const leave = el("button", { type: "button", class: "plain" }, "cancel");
    this.form.append(this.text, this.refused, el("div", {}, keep, leave));
    host.append(el("h2", {}, "expressions", this.edit), this.list, this.form);
    this.edit.addEventListener("click", () => this.open());
    leave.addEventListener("click", () => this.close());
    this.form.addEventListener("submit", (event) => {
      event.preventDefault();
      void this.keep();
    });
    this.text.addEventListener("keydown", (press) => press.stopPropagation());
    app.machine.info.subscribe((machine) => this.draw(machine));
    app.selection.layerStates.subscribe(() => this.draw(app.machine.info.value));
    app.selection.actor.subscribe(() => void this.read());
    setInterval(() => void this.read(), READ_MS);
  }

  private draw(machine: MachineInfo | null): void {
    const lines = machine?.expressions ?? [];
    const ofStates = (machine?.layers ?? []).flatMap(({ states }) =>
      states
        .filter(({ name }) => this.app.selection.layerStates.value.includes(name))
        .flatMap(({ name, expressions }) => expressions.map((line) => this.stateRow(line, name))),
    );
    this.values.clear();
    const rows = [...lines.map((line) => this.row(line)), ...ofStates];
    this.host.hidden = !rows.length;
    const list = el("dl", {}, ...rows);
    this.list.replaceChildren(
      rows.length > MANY ? el("details", {}, el("summary", {}, `${rows.length} expressions`), list) : list,
    );
    void this.read();
  }

  private row(line: ExpressionView): HTMLElement {
    const value = el("output", {}, "");
    this.values.set(line, value);
    const from = line.source === "character" ? el("small", {}, "character") : null;
    const number = el("span", { class: "line", title: `line ${line.line} of its file` }, String(line.line));
    return el("div", {}, number, el("dt", {}, line.name, from), el("dd", {}, line.formula), value);
  }

  private stateRow(line: string, state: string): HTMLElement {
    const [target, formula] = sides(line);
    const name = el("dt", {}, target, el("small", {}, state));
    return el("div", {}, el("span", {}), name, el("dd", {}, formula), el("output", {}, ""));
  }

  private open(): void {
    this.text.value = this.app.machine.info.value?.expression_text ?? "";
    this.text.rows = Math.min(20, Math.max(3, this.text.value.split("\n").length + 1));
    say(this.refused, "");
    this.form.hidden = false;
    this.edit.hidden = true;
    this.text.focus();
  }

  private close(): void {
    this.form.hidden = true;
    this.edit.hidden = false;
  }

  private async keep(): Promise<void> {
    const file = this.app.machine.info.value?.text ?? "";
    try {
      await this.app.editing.expressions(this.text.value);
      this.close();
    } catch (error) {
      if (!(error instanceof ApiError)) throw error;
      const { line, words } = fault(error.message, file);
      say(this.refused, words);
      this.select(line);
    }
  }

  /** Selects a line of the text, from 1. */
  private select(line: number): void {
    const lines = this.text.value.trim().split("\n");
    if (line < 1 || line > lines.length) return;
    const start =
      this.text.value.indexOf(lines.slice(0, line).join("\n")) + lines.slice(0, line - 1).join("\n").length;
    this.text.focus();
    this.text.setSelectionRange(
      start + (line > 1 ? 1 : 0),
      start + (line > 1 ? 1 : 0) + (lines[line - 1] ?? "").length,
    );
  }

  /** Reads the values that the lines set from the actor's facts. */
  private async read(): Promise<void> {
    const actor = this.app.selection.actor.value;
    if (this.host.hidden || actor === null || document.hidden) return;
    const facts = await actorFacts(this.app.stage.id, actor).catch(() => null);
    for (const [line, output] of this.values) say(output, valueOf(line, facts));
  }
}

export function expressionsPanel(host: HTMLElement, app: App): void {
  new ExpressionsPanel(host, app);
}
