/** Edits a cell: a field over it, completions, a trial of the text; Enter keeps it, Escape drops it. */

import "./editor.css";
import type { Answer, CellPlace } from "../../state/editAnswer";
import type { LayerInfo, Operation } from "../../net/protocol";
import { isUnheard } from "../../net/once";
import { reasonOf } from "../../net/reason";
import type { App } from "../../view/app";
import { el, flash } from "../../ui/dom";
import { writtenText } from "./cellText";
import { completions, markersOf, targets } from "./completion";
import type { TrialReport } from "./trialReport";
import { coverCell } from "./fieldPlace";
import { Suggestions } from "./suggestions";

const TRIAL_PAUSE_MS = 180;

const cellOf = ({ layer, state, event }: CellPlace): string => JSON.stringify([layer, state, event]);
const setting = (place: CellPlace, text: string): Operation[] => [{ kind: "set_cell", ...place, text }];
const UNHEARD = "unheard";
const failed = (error: unknown): Answer => ({ kind: "refused", words: reasonOf(error), findings: [] });

export class CellEditor {
  private readonly field = el("input", {
    type: "text",
    class: "cell-field",
    spellcheck: "false",
    autocomplete: "off",
    maxlength: 200,
    role: "combobox",
    hidden: true,
  });
  private readonly suggestions: Suggestions;
  private place: CellPlace | null = null;
  private before = "";
  private byPointer = false;
  /** The answer to the text in the field, if it is refused. */
  private refusal: Answer | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly host: HTMLElement,
    private readonly app: App,
    private readonly inspector: TrialReport,
    private readonly cellAt: (state: string, event: string) => HTMLTableCellElement | null,
  ) {
    host.append(this.field);
    this.suggestions = new Suggestions(inspector.suggestions, this.field, (text) => this.complete(text));
    this.field.addEventListener("input", () => this.typed());
    this.field.addEventListener("keydown", (press) => this.pressed(press));
    this.field.addEventListener("keyup", (press) => press.stopPropagation());
    this.field.addEventListener("blur", ({ relatedTarget }) => this.left(relatedTarget));
    inspector.whenLeft(
      (to) => this.left(to),
      () => this.close(true),
    );
    // The inspector takes height from the table: the cell must stay visible.
    new ResizeObserver(
      () => this.place && this.field.scrollIntoView({ block: "nearest", inline: "nearest" }),
    ).observe(host);
    for (const signal of [app.machine.info, app.selection.layer]) signal.subscribe(() => this.settle());
    app.session.leaving.on(() => this.close(false));
  }

  /** Opens a cell at once; the changed text of the cell before is sent meanwhile. */
  open(cell: HTMLTableCellElement, typed: string | null): void {
    const { state, column: event } = cell.dataset;
    const layer = this.app.machine.layerInfo;
    if (!state || !event || !layer) return;
    if (this.place && cellOf(this.place) !== cellOf({ layer: layer.name, state, event })) this.leave();
    this.place = { layer: layer.name, state, event };
    this.before = writtenText(layer, state, event);
    this.byPointer = !cell.matches(":focus-visible");
    this.field.value = typed ?? this.before;
    this.field.setAttribute("aria-label", `${state}, ${event}`);
    this.field.hidden = false;
    this.settle();
    this.field.focus({ preventScroll: true });
    if (typed === null) this.field.select();
    this.inspector.begin(state, event, layer.table[state]?.[event]);
    this.typed();
  }

  propose(cell: HTMLTableCellElement | null, text: string): void {
    if (cell) this.open(cell, text);
  }

  private get changed(): boolean {
    return this.field.value.trim() !== this.before.trim();
  }

  /** Puts the field over its cell; closes it if the cell is gone or another layer is shown. */
  private settle(): void {
    if (!this.place) return;
    const { layer, state, event } = this.place;
    const cell = this.app.machine.layerInfo?.name === layer ? this.cellAt(state, event) : null;
    if (!cell) return this.close(false);
    coverCell(this.field, cell, this.host);
  }

  private typed(): void {
    const layer = this.app.machine.layerInfo;
    if (!this.place || !layer) return;
    this.settle();
    this.suggest(layer, this.place.state);
    this.tryLater();
  }

  private tryLater(): void {
    this.refusal = null;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.try(), TRIAL_PAUSE_MS);
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
    // Letters and Ctrl+Z belong to the field here, not to the character and the table.
    press.stopPropagation();
    const step = press.key === "ArrowDown" ? 1 : press.key === "ArrowUp" ? -1 : 0;
    if (press.key === "Enter") void this.keep();
    else if (press.key === "Escape") this.close(true);
    else if (press.key === "Tab" && this.suggestions.open)
      this.complete(this.suggestions.first ?? this.field.value);
    else if (step) this.choose(step);
    else return;
    press.preventDefault();
  }

  private choose(by: 1 | -1): void {
    const text = this.suggestions.step(by);
    if (text === null) return;
    this.field.value = text;
    this.tryLater();
  }

  /** Closes an unchanged or refused text when the focus goes elsewhere than to the report. */
  private left(to: EventTarget | null): void {
    if (!this.place || to === this.field || this.inspector.holds(to)) return;
    const [place, text, refusal] = [this.place, this.field.value, this.refusal];
    if (!this.changed) this.close(false);
    // Another window that comes to the front does not leave the cell.
    else if (refusal && document.hasFocus()) {
      this.close(false);
      this.tell(place, text, refusal);
    }
  }

  /** Sends a changed text and closes without waiting for the answer. */
  leave(): void {
    if (this.changed) void this.keep();
    this.close(false);
  }

  private async try(): Promise<void> {
    clearTimeout(this.timer);
    const place = this.place;
    if (!place) return;
    if (!this.changed) {
      this.inspector.unchanged();
      return;
    }
    this.inspector.trying();
    const trial = this.app.editing.try(setting(place, this.field.value));
    const answer = await trial.catch((error: unknown) => (isUnheard(error) ? UNHEARD : failed(error)));
    if (!answer || place !== this.place) return;
    if (answer === UNHEARD) this.inspector.unheard();
    else this.show(answer);
  }

  /**
   * Keeps the text. A refused text stays in the open field; if the field has moved on, a notice says why the
   * text is not kept.
   */
  private async keep(): Promise<void> {
    clearTimeout(this.timer);
    const [place, text, before] = [this.place, this.field.value, this.before];
    if (!place) return;
    if (!this.changed) {
      this.close(true);
      return;
    }
    this.inspector.trying();
    const answer = await this.app.editing.keep(setting(place, text)).catch(failed);
    if (answer.kind === "fine") this.kept(place, text);
    else if (place === this.place) this.show(answer);
    else if (answer.kind === "stale" && this.written(place) === before) await this.keepAgain(place, text);
    else this.tell(place, text, answer);
  }

  /** Sends the text again, on top of another editor's change of another cell. */
  private async keepAgain(place: CellPlace, text: string): Promise<void> {
    const answer = await this.app.editing.keep(setting(place, text)).catch(failed);
    if (answer.kind === "fine") this.kept(place, text);
    else this.tell(place, text, answer);
  }

  private tell({ state, event }: CellPlace, text: string, { words, findings }: Answer): void {
    const reason = findings[0]?.message ?? words;
    this.app.notices.emit(`${state}, ${event}: “${text}” is not kept. ${reason}`);
  }

  private written({ layer, state, event }: CellPlace): string {
    const info = this.app.machine.info.value?.layers.find(({ name }) => name === layer);
    return info ? writtenText(info, state, event) : "";
  }

  private kept(place: CellPlace, text: string): void {
    if (place === this.place) {
      if (text === this.field.value) this.close(true);
      else this.before = text;
    }
    const cell =
      this.app.machine.layerInfo?.name === place.layer ? this.cellAt(place.state, place.event) : null;
    if (cell) flash(cell, "shown");
  }

  private show(answer: Answer): void {
    this.refusal = answer.kind === "refused" ? answer : null;
    this.field.setAttribute("aria-invalid", String(this.refusal !== null));
    this.inspector.show(answer);
    // The other editor's version was read: the text is tried on top of it.
    if (answer.kind === "stale") this.tryLater();
  }

  /** Closes the field. The focus goes `back` to the cell, unless the field was opened by a click. */
  private close(back: boolean): void {
    const place = this.place;
    this.place = this.refusal = null;
    clearTimeout(this.timer);
    this.suggestions.show([]);
    this.field.hidden = true;
    this.field.removeAttribute("aria-invalid");
    this.inspector.end();
    if (place && back && !this.byPointer)
      this.cellAt(place.state, place.event)?.focus({ preventScroll: true });
  }
}
