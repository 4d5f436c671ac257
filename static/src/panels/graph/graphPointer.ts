/** Mouse and touch in the graph: hover, click, double click, and drags of states and new arrows. */

import type { App } from "../../view/app";
import { makeArrow } from "./graphEdits";
import type { GraphView } from "./graphView";
import { type Drag, Gestures } from "./gestures";
import type { Point } from "./shapes";

export class GraphPointer {
  private readonly gestures: Gestures;
  private pointed: SVGElement | null = null;
  /** The press of a click: what it was on counts, although labels may come and go until the release. */
  private press: PointerEvent | null = null;

  constructor(
    private readonly graph: GraphView,
    private readonly app: App,
  ) {
    const { canvas } = graph.picture;
    this.gestures = new Gestures(canvas, graph.camera, (target, place) => this.begin(target, place));
    canvas.addEventListener("pointerdown", (press) => (this.press = press));
    canvas.addEventListener("click", (click) => this.clicked((click.pointerType && this.press) || click));
    for (const kind of ["contextmenu", "dblclick"])
      canvas.addEventListener(kind, (click) => this.travel(click));
    canvas.addEventListener("pointerover", ({ target }) => graph.light(stateOf(target) ?? ""));
    canvas.addEventListener("pointermove", (move) => this.point(this.edgeAt(move)));
    canvas.addEventListener("pointerleave", () => {
      graph.light("");
      this.point(null);
    });
  }

  /** Drops what is dragged; returns whether something was. */
  cancel(): boolean {
    return this.gestures.cancel();
  }

  /** Marks the arrow that a click would select. */
  private point(edge: SVGElement | null): void {
    if (edge === this.pointed) return;
    this.pointed?.classList.remove("pointed");
    edge?.classList.add("pointed");
    this.pointed = edge;
  }

  /** Returns the arrow at a pointer: where arrows lie close together, the nearest one. */
  private edgeAt({ target, clientX: x, clientY: y, pointerType }: PointerEvent): SVGElement | null {
    const edge = target instanceof Element ? target.closest<SVGElement>(".edge") : null;
    if (!edge || !pointerType || (target as Element).closest("text")) return edge;
    return this.graph.picture.nearestArrow(this.graph.camera.toGraph({ x, y }));
  }

  private clicked(click: PointerEvent): void {
    if (this.gestures.dragged) return;
    const { target } = click;
    const edge = this.edgeAt(click);
    const state = stateOf(target);
    if (state !== null) this.graph.select(state);
    else if (edge) this.graph.select(edge.dataset["from"]!, eventOf(target as Element, edge));
    else this.graph.select(null);
  }

  /** Travels to a state on double click or right click, in the base layer only; unfolds a sub-machine. */
  private travel(click: Event): void {
    const state = stateOf(click.target);
    if (state === null) return;
    if (this.graph.isFolded(state)) this.graph.unfold(state);
    else if (this.app.selection.layer.value === 0) void this.app.travel.go(state);
    else return;
    click.preventDefault();
  }

  private begin(target: Element, start: Point): Drag | null {
    const state = stateOf(target);
    if (state === null) return null;
    if (target.matches(".rim")) return this.drawing(state);
    return this.graph.isPart || this.graph.isFolded(state) ? null : this.moving(state, start);
  }

  private moving(state: string, start: Point): Drag {
    const { graph } = this;
    const before = graph.places.get(state)!;
    return {
      move: ({ x, y }) => graph.move(state, { x: before.x + x - start.x, y: before.y + y - start.y }),
      end: () => void graph.keep(state),
      cancel: () => graph.move(state, before),
    };
  }

  private drawing(from: string): Drag {
    const { picture } = this.graph;
    let last: Point = { x: 0, y: 0 };
    return {
      move: (place) => picture.drawGhost(from, (last = place)),
      end: (target) => {
        const to = stateOf(target);
        if (to === null) return picture.drawGhost(from, null);
        void makeArrow(this.app, from, to, this.graph.camera.toWindow(last)).then((event) => {
          picture.drawGhost(from, null);
          if (event !== null) this.graph.select(from, event);
        });
      },
      cancel: () => picture.drawGhost(from, null),
    };
  }
}

function stateOf(target: EventTarget | null): string | null {
  return target instanceof Element
    ? (target.closest<SVGElement>(".state, .halo")?.dataset["state"] ?? null)
    : null;
}

/** Returns the event whose name was clicked, or the arrow's first one. */
function eventOf(target: Element, edge: SVGElement): string {
  return (
    target.closest<SVGElement>("[data-label]")?.dataset["label"] ??
    edge.querySelector("tspan")!.dataset["label"]!
  );
}
