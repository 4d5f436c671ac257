/** Draws the graph: states, arrows with their labels; marks what is live, selected, and what is pointed at. */

import { flash, svg } from "../../ui/dom";
import { direction, leadArrows, nearest } from "./arrows";
import type { Content } from "./content";
import { arrowHead, bendArrow, drawArrow, drawHalo, drawState, placeState, writeLabel } from "./drawing";
import { placeLabels } from "./labels";
import { letterWidths } from "./letterWidths";
import { isDense } from "./ringLayout";
import {
  type Arrow,
  type Box,
  type Places,
  type Point,
  type Rect,
  type Size,
  around,
  pointAt,
  rectAt,
  rectOf,
  stateWidth,
} from "./shapes";

/** The height of a label's letters, pixels, at every zoom. */
const LETTERS = 11;
/** Above it only the arrows of live, selected and pointed at states are drawn. */
const MOST_ARROWS = 400;

/** What stands out. */
export interface Marks {
  live: string;
  /** The state that is pointed at or has the focus, "" for none. */
  lit: string;
  selected: { state: string; event: string | null; to: string } | null;
}

export class Picture {
  readonly canvas = svg("svg", { role: "group", "aria-label": "state graph" });
  readonly world = svg("g", { class: "world" });
  private readonly arrowGroup = svg("g");
  /** Below all states: no state lies under the halo of another. */
  private readonly haloGroup = svg("g");
  private readonly stateGroup = svg("g");
  private readonly ghost = svg("path", { class: "line ghost", hidden: true });
  private content: Content = { nodes: [], edges: [], initial: "" };
  private boxes = new Map<string, Box>();
  private arrows: Arrow[] = [];
  private readonly states = new Map<string, SVGGElement>();
  private readonly halos = new Map<string, SVGElement>();
  private readonly edges = new Map<string, SVGGElement>();
  private marks: Marks = { live: "", lit: "", selected: null };
  private zoom = 1;
  /** The size of the panel, pixels. */
  room: Size = { width: 0, height: 0 };
  /** Measured when the first labels are placed: then the page has its font. */
  private widthOf: ((text: string) => number) | null = null;

  constructor() {
    this.world.append(this.arrowGroup, this.haloGroup, this.stateGroup, this.ghost);
    this.canvas.append(arrowHead(), this.world);
  }

  show(content: Content, places: Places): void {
    this.content = content;
    this.boxes = new Map(
      content.nodes.map(({ name }) => [name, { name, ...places.get(name)!, width: stateWidth(name) }]),
    );
    this.states.clear();
    this.halos.clear();
    for (const node of content.nodes) {
      const box = this.boxes.get(node.name)!;
      this.states.set(node.name, drawState(box, node, node.name === content.initial));
      this.halos.set(node.name, drawHalo(box));
      this.place(box);
    }
    this.stateGroup.replaceChildren(...this.states.values());
    this.haloGroup.replaceChildren(...this.halos.values());
    this.canvas.classList.toggle("dense", isDense(content.nodes.length, content.edges.length));
    this.drawArrows();
    this.mark(this.marks);
  }

  /** Moves one state, with its arrows. */
  move(name: string, place: Point): void {
    const box = this.boxes.get(name);
    if (!box) return;
    Object.assign(box, place);
    this.place(box);
    this.drawArrows();
    this.mark(this.marks);
  }

  private place(box: Box): void {
    for (const parts of [this.states, this.halos]) placeState(parts.get(box.name)!, box);
  }

  mark(marks: Marks): void {
    const [before, { live, lit, selected }] = [this.marks, marks];
    this.marks = marks;
    if (this.isLarge && (before.live !== live || before.lit !== lit || before.selected !== selected))
      this.drawArrows();
    for (const [name, group] of this.states) {
      group.classList.toggle("live", name === live);
      group.toggleAttribute("aria-current", name === live);
      const pressed = selected?.state === name && selected.event === null;
      group.setAttribute("aria-pressed", String(pressed));
    }
    for (const arrow of this.arrows) {
      const [{ from, to }, group] = [arrow, this.element(arrow)];
      group.classList.toggle("near", from === live);
      group.classList.toggle("lit", lit !== "" && (from === lit || to === lit));
      const chosen = selected?.event != null && selected.state === from && selected.to === to;
      group.setAttribute("aria-pressed", String(chosen));
      for (const part of group.querySelectorAll("tspan"))
        part.classList.toggle("chosen", chosen && part.dataset["label"] === selected.event);
    }
    this.canvas.classList.toggle("lighting", lit !== "");
    this.write();
  }

  /** Follows the zoom: labels, and what can be hit, keep their size on the screen. */
  zoomed(zoom: number): void {
    this.zoom = zoom;
    this.world.style.setProperty("--per-pixel", (1 / zoom).toFixed(3));
    this.world.style.setProperty("--letters", `${(LETTERS / zoom).toFixed(2)}px`);
  }

  /** Places the labels: of the arrows at the state that is pointed at, else of all. */
  write(): void {
    const { lit, live } = this.marks;
    const shown = this.arrows.filter(({ from, to }) =>
      lit ? from === lit || to === lit : !this.canvas.classList.contains("dense") || from === live,
    );
    const written = shown.map((arrow) => ({ ...arrow, events: this.inOrder(arrow) }));
    this.widthOf ??= letterWidths();
    const letters = { size: LETTERS / this.zoom, widthOf: this.widthOf };
    const labels = placeLabels(written, this.boxes.values(), letters, this.field);
    written.forEach((arrow, i) => writeLabel(this.element(arrow), arrow, labels[i] ?? null));
  }

  /** Returns an arrow's events; the one that has fired comes first. */
  private inOrder(arrow: Arrow): string[] {
    const fired = this.element(arrow).dataset["fired"];
    return [...arrow.events].sort((a, b) => Number(b === fired) - Number(a === fired));
  }

  private element({ from, to }: Arrow): SVGGElement {
    return this.edges.get(direction(from, to))!;
  }

  /** Flashes the arrow that a state change has taken, and writes its event. */
  fire(from: string, to: string, event: string): void {
    const group = this.edges.get(direction(from, to));
    if (!group) return;
    this.arrowGroup.querySelectorAll(".last").forEach((old) => old.classList.remove("last"));
    flash(group, "fired");
    group.classList.add("last");
    if (group.dataset["fired"] === event) return;
    group.dataset["fired"] = event;
    this.write();
  }

  /** Draws an arrow that is not made yet, from a state to a place. */
  drawGhost(from: string, place: Point | null): void {
    const box = this.boxes.get(from);
    this.ghost.toggleAttribute("hidden", !place || !box);
    if (place && box) this.ghost.setAttribute("d", `M${box.x} ${box.y}L${place.x} ${place.y}`);
  }

  box(name: string): Box | undefined {
    return this.boxes.get(name);
  }

  get drawnEdges(): Content["edges"] {
    return this.content.edges;
  }

  /** Returns the element of the arrow that is nearest to a place; null if no arrow is drawn. */
  nearestArrow(place: Point): SVGGElement | null {
    const arrow = nearest(this.arrows, place);
    return arrow && this.element(arrow);
  }

  get placed(): Iterable<Box> {
    return this.boxes.values();
  }

  /** Returns the arrows that leave a state, in the order of the table. */
  leaving(state: string): Arrow[] {
    return this.arrows.filter(({ from }) => from === state);
  }

  stateElement(name: string): SVGGElement | undefined {
    return this.states.get(name);
  }

  arrowElement(from: string, to: string): SVGGElement | undefined {
    return this.edges.get(direction(from, to));
  }

  /** Returns the rectangle around states and arrows, or null if nothing is drawn. */
  get bounds(): Rect | null {
    const points = this.arrows.flatMap(({ curve }) => [pointAt(curve, 0.33), pointAt(curve, 0.66)]);
    const rects = [
      ...[...this.boxes.values()].map((box) => rectOf(box, 2)),
      ...points.map(({ x, y }) => ({ left: x, top: y, right: x, bottom: y })),
    ];
    return rects.length ? around(rects) : null;
  }

  /** The part of the graph that is seen when the camera fits the drawing: no label leaves it. */
  private get field(): Rect {
    const { left, top, right, bottom } = this.bounds ?? { left: 0, top: 0, right: 0, bottom: 0 };
    const { width, height } = this.room;
    const middle = { x: (left + right) / 2, y: (top + bottom) / 2 };
    const half = {
      x: Math.max(right - left, width / this.zoom) / 2,
      y: Math.max(bottom - top, height / this.zoom) / 2,
    };
    return rectAt(middle, half);
  }

  private get isLarge(): boolean {
    return this.content.edges.length > MOST_ARROWS;
  }

  private drawArrows(): void {
    const { live, lit, selected } = this.marks;
    const near = new Set([live, lit, selected?.state ?? ""]);
    const edges = this.isLarge
      ? this.content.edges.filter(({ from, to }) => near.has(from) || to === lit)
      : this.content.edges;
    this.arrows = leadArrows(edges, this.boxes);
    const before = new Map(this.edges);
    this.edges.clear();
    for (const arrow of this.arrows) {
      const key = direction(arrow.from, arrow.to);
      const old = before.get(key);
      // An arrow that stays keeps its element, and with it the focus.
      const stays = old?.dataset["events"] === arrow.events.join() ? old : null;
      const group = stays ?? drawArrow(arrow);
      if (stays) before.delete(key);
      else this.arrowGroup.append(group);
      bendArrow(group, arrow);
      this.edges.set(key, group);
    }
    for (const gone of before.values()) gone.remove();
  }
}
