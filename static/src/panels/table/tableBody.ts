/** Draws the lines of a table that are in sight: a browser lays a table of 12,000 cells out too slowly. */

import { el } from "../../ui/dom";
import { drawnLines, gaps } from "./rowWindow";

/** A line of the table: the row of a state, or the head of a sub-machine. */
export interface Line {
  /** The state, or the folded sub-machine; "": the head of an unfolded one. */
  name: string;
  /** Whether it is the row of a state. */
  isState: boolean;
  /** Returns everything that `draw` depends on, as one text: a drawn row stays while this text is the same. */
  text: () => string;
  draw: () => HTMLTableRowElement;
}

/** Pixels, until a row is measured. */
const LINE_HEIGHT = 27;

export class TableBody {
  readonly element = el("tbody");
  private lines: readonly Line[] = [];
  private places = new Map<string, number>();
  private drawn = new Map<number, HTMLTableRowElement>();
  private readonly texts = new WeakMap<HTMLTableRowElement, string>();
  /** The line that was asked for last. */
  private asked = -1;

  /** `host`: what scrolls. */
  constructor(private readonly host: HTMLElement) {
    host.addEventListener("scroll", () => this.show(), { passive: true });
    new ResizeObserver(() => this.show()).observe(host);
  }

  /** Takes other lines in place of all; after an edit, most rows that are drawn stay. */
  fill(lines: readonly Line[]): void {
    this.lines = lines;
    this.places = new Map(lines.flatMap(({ name }, i) => (name ? [[name, i] as const] : [])));
    const stays = ([line, row]: [number, HTMLTableRowElement]): boolean =>
      this.texts.get(row) === lines[line]?.text();
    this.drawn = new Map([...this.drawn].filter(stays));
    this.asked = -1;
    this.show(true);
  }

  /** The states of the rows, from the top. */
  get states(): string[] {
    return this.lines.filter(({ isState }) => isState).map(({ name }) => name);
  }

  /**
   * Returns the row of a state or the line of a folded sub-machine, and draws it if it is out of sight; null: the
   * table does not have it.
   */
  row(name: string): HTMLTableRowElement | null {
    const line = this.places.get(name);
    if (line === undefined) return null;
    if (!this.drawn.has(line)) {
      this.asked = line;
      this.show();
    }
    return this.drawn.get(line) ?? null;
  }

  /** The rows of states and the lines of folded sub-machines that are drawn. */
  *rows(): Iterable<[string, HTMLTableRowElement]> {
    for (const [line, row] of this.drawn) if (this.lines[line]!.name) yield [this.lines[line]!.name, row];
  }

  /**
   * Draws the rows that are in sight now. A row that stays keeps its element, and its element keeps the focus. The method
   * measures first and changes the page afterwards: a change between two measurements would make the browser lay the
   * page out twice, and could scroll it.
   */
  private show(isNew = false): void {
    const height = this.measured;
    const sight = { top: this.host.scrollTop, height: this.host.clientHeight, line: height };
    const wanted = drawnLines(this.lines.length, sight, [this.asked, this.reachable()]);
    const isShown = wanted.length === this.drawn.size && wanted.every((line) => this.drawn.has(line));
    if (isShown && !isNew) return;
    const before = this.drawn;
    this.drawn = new Map(wanted.map((line) => [line, before.get(line) ?? this.draw(line)]));
    const left = gaps(this.lines.length, wanted);
    const elements = wanted.flatMap((line, i) => [...gap(left[i]! * height), this.drawn.get(line)!]);
    this.put([...elements, ...gap(left.at(-1)! * height)]);
  }

  private draw(line: number): HTMLTableRowElement {
    const row = this.lines[line]!.draw();
    this.texts.set(row, this.lines[line]!.text());
    row.dataset["line"] = String(line);
    row.setAttribute("aria-rowindex", String(line + 2));
    return row;
  }

  /** Shows these elements alone, in their order. It moves no element that is there already: that would lose the focus. */
  private put(elements: readonly HTMLElement[]): void {
    const shown = new Set<Element>(elements);
    for (const old of [...this.element.children]) if (!shown.has(old)) old.remove();
    let next = this.element.firstElementChild;
    for (const element of elements)
      if (element === next) next = next.nextElementSibling;
      else this.element.insertBefore(element, next);
  }

  /** The line whose cell Tab reaches. */
  private reachable(): number {
    const cell = this.element.querySelector<HTMLElement>("[tabindex='0']");
    return Number(cell?.closest("tr")?.dataset["line"] ?? -1);
  }

  private get measured(): number {
    const [row] = this.drawn.values();
    return row?.offsetHeight || LINE_HEIGHT;
  }
}

/** Makes the room of lines that are not drawn. */
function gap(height: number): HTMLElement[] {
  if (!height) return [];
  const room = el("td");
  room.style.height = `${height}px`;
  return [el("tr", { class: "gap", "aria-hidden": "true" }, room)];
}
