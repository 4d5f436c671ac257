/** A cell being edited: a field over it, completions, a trial of what is typed, and Enter or Escape. */

import type { Answer, Editing } from "../../editing";
import type { LayerInfo } from "../../net/protocol";
import type { Session } from "../../session";
import { el, flash } from "../dom";
import { writtenText } from "./celltext";
import { completions, markersOf, targets } from "./completion";
import type { Desk } from "./desk";
import { Suggestions } from "./suggestions";

const TRIAL_PAUSE_MS = 180;

interface Place {
  layer: string;
  state: string;
  event: string;
}

export class CellEditor {
  private readonly field = el("input", { type: "text", class: "cell-field", spellcheck: "false", autocomplete: "off", maxlength: 200, role: "combobox", "aria-controls": "suggestions", hidden: true });
  private readonly suggestions: Suggestions;
  private place: Place | null = null;
  private before = "";
  private byPointer = false;
  private timer: ReturnType<typeof setTimeout> | undefined;
  /** Counts trials: only the newest one's answer is shown. */
  private trials = 0;
  /** The request under way: one at a time, or a trial could come after the edit that it was a trial of. */
  private line: Promise<unknown> = Promise.resolve();

  constructor(
    private readonly host: HTMLElement,
    private readonly session: Session,
    private readonly editing: Editing,
    private readonly desk: Desk,
    private readonly cellAt: (state: string, event: string) => HTMLTableCellElement | null,
  ) {
    host.append(this.field);
    this.suggestions = new Suggestions(desk.suggestions, (text) => this.complete(text));
    this.field.addEventListener("input", () => this.typed());
    this.field.addEventListener("keydown", (press) => this.pressed(press));
    this.field.addEventListener("keyup", (press) => press.stopPropagation());
    this.field.addEventListener("blur", () => this.left());
    // The desk below takes room from the table: the cell stays in sight.
    new ResizeObserver(() => this.place && this.field.scrollIntoView({ block: "nearest", inline: "nearest" })).observe(host);
    for (const signal of [session.machine, session.layer]) signal.on(() => this.settle());
    session.leaving.on(() => this.close(false));
  }

  /** Edits a cell; what is typed in another one is kept first, and stays there where it is refused. */
  async open(cell: HTMLTableCellElement, typed: string | null): Promise<void> {
    const { state, column: event } = cell.dataset;
    const layer = this.session.layerInfo;
    if (!state || !event || !layer || (this.place && !(await this.leave()))) return;
    this.place = { layer: layer.name, state, event };
    this.before = writtenText(layer, state, event);
    this.byPointer = !cell.matches(":focus-visible");
    this.field.value = typed ?? this.before;
    this.field.setAttribute("aria-label", `${state}, ${event}`);
    this.field.hidden = false;
    this.settle();
    this.field.focus({ preventScroll: true });
    if (typed === null) this.field.select();
    this.desk.begin(state, event, layer.table[state]?.[event]);
    this.typed();
  }

  /** Edits a cell with a text that was proposed. */
  async propose(cell: HTMLTableCellElement | null, text: string): Promise<void> {
    if (cell) await this.open(cell, text);
  }

  private get changed(): boolean {
    return this.field.value.trim() !== this.before.trim();
  }

  /** The field lies over its cell; where that is gone, or another layer is shown, there is nothing to edit. */
  private settle(): void {
    if (!this.place) return;
    const { layer, state, event } = this.place;
    const cell = this.session.layerInfo?.name === layer ? this.cellAt(state, event) : null;
    if (!cell) return this.close(false);
    const width = Math.max(cell.offsetWidth, Math.min(170, this.host.clientWidth));
    const left = Math.min(cell.offsetLeft, Math.max(0, this.host.scrollWidth - width));
    Object.assign(this.field.style, { left: `${left}px`, top: `${cell.offsetTop}px`, width: `${width}px`, height: `${cell.offsetHeight}px` });
  }

  private typed(): void {
    const layer = this.session.layerInfo;
    if (!this.place || !layer) return;
    this.suggest(layer, this.place.state);
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.keepOr(true), TRIAL_PAUSE_MS);
  }

  private suggest(layer: LayerInfo, state: string): void {
    const texts = completions(this.field.value, targets(layer, state), markersOf(layer, state));
    this.suggestions.show(this.changed || !this.before ? texts : []);
  }

  private complete(text: string): void {
    this.field.value = text;
    this.typed();
  }

  private pressed(press: KeyboardEvent): void {
    // The character's keys are letters here; undo by Ctrl+Z is the field's own.
    press.stopPropagation();
    const step = press.key === "ArrowDown" ? 1 : press.key === "ArrowUp" ? -1 : 0;
    if (press.key === "Enter") void this.keepOr(false);
    else if (press.key === "Escape") this.close(true);
    else if (press.key === "Tab" && this.suggestions.open) this.complete(this.suggestions.first ?? this.field.value);
    else if (step) this.choose(step as 1 | -1);
    else return;
    press.preventDefault();
  }

  private choose(by: 1 | -1): void {
    const text = this.suggestions.step(by);
    if (text === null) return;
    this.field.value = text;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.keepOr(true), TRIAL_PAUSE_MS);
  }

  private left(): void {
    if (!this.changed) this.close(false);
  }

  /** Before another cell is edited: keeps what was changed. Says whether this cell is done with. */
  private async leave(): Promise<boolean> {
    if (this.changed) await this.keepOr(false);
    else this.close(false);
    return this.place === null;
  }

  /** Tries what is typed (`dry`), or keeps it. What is refused stays in the cell. */
  private async keepOr(dry: boolean): Promise<void> {
    clearTimeout(this.timer);
    const [place, text, trial] = [this.place, this.field.value, ++this.trials];
    if (!place) return;
    if (!this.changed) return dry ? this.desk.unchanged() : this.close(true);
    this.desk.trying();
    const asked = this.line.then(() => (dry && trial !== this.trials ? null : this.editing.cell(place, text, dry)));
    this.line = asked.catch(() => null);
    const answer = await asked.catch((error: Error): Answer => ({ kind: "refused", words: error.message, findings: [] }));
    if (!answer || trial !== this.trials || place !== this.place) return;
    if (answer.kind === "fine" && !dry) return this.kept(place);
    this.field.setAttribute("aria-invalid", String(answer.kind === "refused"));
    this.desk.show(answer);
    // Somebody else's edit was read in; what is typed here is tried on top of it.
    if (answer.kind === "stale") this.timer = setTimeout(() => void this.keepOr(true), TRIAL_PAUSE_MS);
  }

  private kept(place: Place): void {
    this.close(true);
    const cell = this.cellAt(place.state, place.event);
    if (cell) flash(cell, "shown");
  }

  /** Drops what is typed. The keyboard goes back to the cell, or, after a click, to the character. */
  private close(back: boolean): void {
    const place = this.place;
    this.place = null;
    clearTimeout(this.timer);
    this.suggestions.show([]);
    this.field.hidden = true;
    this.field.removeAttribute("aria-invalid");
    this.desk.end();
    if (place && back && !this.byPointer) this.cellAt(place.state, place.event)?.focus({ preventScroll: true });
  }
}
