/** The keyboard in the graph: from state to state, from arrow to arrow, new arrows, zoom. */

import type { App } from "../../view/app";
import { deleteArrow, makeArrow } from "./graphEdits";
import { stateTowards } from "./graphMoves";
import type { GraphView } from "./graphView";

/** Milliseconds without a step after which a place is kept. */
const REST_MS = 400;
const [PAN, STEP, ZOOM] = [40, 8, 1.25];
const ABOUT_A_CLICK = new Set(["Delete", "Backspace", "Escape", "+", "=", "-", "0"]);
const ARROWS: Record<string, readonly [number, number]> = {
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
};

/** In words, for the help and for screen readers. */
export const GRAPH_KEYS =
  "arrow keys: to the next state; N, P: its arrows; Enter: open; A: a new arrow; Delete: the arrow's cell; " +
  "T: travel, or unfold; Shift and arrow keys: move the state; + − 0: zoom, fit";

export class GraphKeys {
  /** The state from which a new arrow begins, or null. */
  private from: string | null = null;
  private keeping: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly graph: GraphView,
    private readonly app: App,
    private readonly say: (words: string) => void,
    private readonly cancelDrag: () => boolean,
  ) {
    const { canvas } = graph.picture;
    canvas.addEventListener("keydown", (press) => this.pressed(press));
    canvas.addEventListener("focusin", ({ target }) => graph.light(near(target) ?? ""));
    canvas.addEventListener("focusout", () => graph.light(""));
  }

  /** Handles keys of the focused state or arrow; they do not reach the character. */
  private pressed(press: KeyboardEvent): void {
    if (press.ctrlKey || press.metaKey || press.key === "Tab") return;
    const element = (press.target as Element).closest<SVGElement>(".state, .edge");
    // After a click the keyboard still belongs to the character, but for the keys that are about the click.
    if (!element?.matches(":focus-visible") && !ABOUT_A_CLICK.has(press.key)) return;
    press.stopPropagation();
    if (this.look(press) || (element && this.act(press, element))) press.preventDefault();
  }

  private look({ key, altKey }: KeyboardEvent): boolean {
    const { camera } = this.graph;
    const step = ARROWS[key];
    if (altKey && step) camera.pan(-step[0] * PAN, -step[1] * PAN);
    else if (key === "+" || key === "=") camera.zoomBy(ZOOM);
    else if (key === "-" || key === "−") camera.zoomBy(1 / ZOOM);
    else if (key === "0") this.graph.fit();
    else return false;
    return true;
  }

  private act(press: KeyboardEvent, element: SVGElement): boolean {
    const { state, from, to } = element.dataset;
    if (press.key === "Escape") return this.drop(element);
    if (press.key.toLowerCase() === "n" || press.key.toLowerCase() === "p")
      return this.nextArrow(state ?? from!, to, press.key.toLowerCase() === "n" ? 1 : -1);
    return state !== undefined ? this.actOnState(press, state) : this.actOnArrow(press, element);
  }

  private actOnState({ key, shiftKey }: KeyboardEvent, state: string): boolean {
    if (ARROWS[key] && shiftKey) this.shift(state, ARROWS[key]);
    else if (ARROWS[key]) this.go(state, key);
    else if (key === "Enter" && this.from !== null) this.finish(this.from, state);
    else if (key === "Enter" || key === " ") this.graph.select(state);
    else if (this.graph.isFolded(state)) return this.actOnFolded(key, state);
    else if (key.toLowerCase() === "a") this.start(state);
    else if (key.toLowerCase() === "t") void this.app.travel.go(state);
    else return false;
    return true;
  }

  /** A folded sub-machine can't be travelled to, and begins no arrow; T unfolds it. */
  private actOnFolded(key: string, name: string): boolean {
    if (key.toLowerCase() !== "t") return false;
    this.graph.unfold(name);
    return true;
  }

  private actOnArrow({ key }: KeyboardEvent, element: SVGElement): boolean {
    const { from, to, events } = element.dataset;
    if (key === "ArrowRight" || key === "ArrowDown") this.graph.focus(to!);
    else if (key === "ArrowLeft" || key === "ArrowUp") this.graph.focus(from!);
    else if (key === "Enter" || key === " ") this.open(from!, events!.split(","));
    else if (key === "Delete" || key === "Backspace") this.remove(from!, to!, events!.split(","));
    else return false;
    return true;
  }

  private go(state: string, key: string): void {
    const { picture } = this.graph;
    const next = stateTowards(state, key, [...picture.placed], picture.drawnEdges);
    if (next === null) return;
    this.graph.focus(next);
    const place = this.graph.places.get(next);
    if (this.from !== null && place) this.graph.picture.drawGhost(this.from, place);
  }

  private nextArrow(state: string, to: string | undefined, by: 1 | -1): boolean {
    const arrows = this.graph.picture.leaving(state);
    if (!arrows.length) return true;
    const index = arrows.findIndex((arrow) => arrow.to === to);
    const next = arrows[(Math.max(index, by < 0 ? 0 : -1) + by + arrows.length) % arrows.length]!;
    const element = this.graph.picture.arrowElement(next.from, next.to)!;
    this.graph.rove(element);
    element.focus({ preventScroll: true });
    return true;
  }

  /** Selects the arrow's first event; opened again, the next one, and shows its cell in the table. */
  private open(from: string, events: readonly string[]): void {
    const event = this.chosen(from, events);
    const again = event !== null;
    const next = again ? events[(events.indexOf(event) + 1) % events.length]! : events[0]!;
    this.graph.select(from, next);
    if (again && events.length === 1)
      this.app.inspection.cells.emit({
        layer: this.app.selection.layer.value,
        state: from,
        event: next,
        text: null,
      });
  }

  private chosen(from: string, events: readonly string[]): string | null {
    const selected = this.app.inspection.selected.value;
    return selected?.state === from && selected.event !== null && events.includes(selected.event)
      ? selected.event
      : null;
  }

  private remove(from: string, to: string, events: readonly string[]): void {
    const event = this.chosen(from, events) ?? events[0]!;
    const layer = this.app.machine.layerInfo?.name ?? "";
    void deleteArrow(this.app, { layer, state: from, event }).then((gone) => {
      if (gone && !this.graph.picture.arrowElement(from, to)) this.graph.focus(from);
    });
  }

  private shift(state: string, [x, y]: readonly [number, number]): void {
    const place = this.graph.places.get(state);
    if (!place || this.graph.isPart || this.graph.isFolded(state)) return;
    this.graph.move(state, { x: place.x + x * STEP, y: place.y + y * STEP });
    this.keepLater(state);
  }

  /** Keeps a place when the keys have rested: a row of steps is one edit. */
  private keepLater(state: string): void {
    clearTimeout(this.keeping);
    this.keeping = setTimeout(() => void this.graph.keep(state), REST_MS);
  }

  private start(state: string): void {
    this.from = state;
    this.say(`a new arrow from ${state}: arrow keys to a state, Enter; Escape drops it`);
    const place = this.graph.places.get(state);
    if (place) this.graph.picture.drawGhost(state, place);
  }

  private finish(from: string, to: string): void {
    this.drop(null);
    const { x, y } = this.graph.places.get(to)!;
    void makeArrow(this.app, from, to, this.graph.camera.toWindow({ x, y })).then((event) => {
      if (event !== null) this.graph.select(from, event);
      this.graph.focus(from);
    });
  }

  /** Ends a new arrow without making it; Escape once more leaves the graph. */
  private drop(element: SVGElement | null): boolean {
    if (this.from === null && !this.cancelDrag() && element) element.blur();
    if (this.from !== null) this.graph.picture.drawGhost(this.from, null);
    this.from = null;
    this.say("");
    return true;
  }
}

function near(target: EventTarget | null): string | undefined {
  const element = target instanceof Element ? target.closest<SVGElement>(".state, .edge") : null;
  return element?.dataset["state"] ?? element?.dataset["from"];
}
