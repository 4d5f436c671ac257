/** Draws the state graph; marks the live state and flashes transitions as they fire. */

import "./graph.css";
import type { LayerInfo, Verdict } from "../../net/protocol";
import type { App } from "../../view/app";
import { el, flash, say, svg } from "../../ui/dom";
import { layoutGraph } from "./layout";
import { statesToDraw } from "./neighbours";
import { type PlacedEdge, type PlacedState, STATE_HEIGHT } from "./shapes";

/** Pixels around the drawing, for strokes. */
const MARGIN = 4;

const edgeKey = (from: string, to: string): string => JSON.stringify([from, to]);

function arrowHead(): SVGElement {
  const tip = svg("path", { d: "M0 0L8 4L0 8Z" });
  const size = {
    viewBox: "0 0 8 8",
    refX: 7,
    refY: 4,
    markerWidth: 8,
    markerHeight: 8,
    markerUnits: "userSpaceOnUse",
  };
  return svg("defs", {}, svg("marker", { id: "arrow", class: "tip", orient: "auto", ...size }, tip));
}

function shortList(events: readonly string[]): string {
  return events.length > 2 ? `${events[0]} +${events.length - 1}` : events.join(", ");
}

function drawEdge(edge: PlacedEdge): SVGGElement {
  const atEnd = edge.events.every((event) => event === "END");
  const title = svg("title", {}, `${edge.from} → ${edge.to}: ${edge.events.join(", ")}`);
  const paths = ["reach", "line"].map((name) => svg("path", { class: name, d: edge.path }));
  const label = svg("text", { x: edge.x, y: edge.y + 3, "text-anchor": "middle" }, shortList(edge.events));
  return svg("g", { class: atEnd ? "edge at-end" : "edge" }, title, ...paths, label);
}

function drawState({ name, x, y, width }: PlacedState, machine: LayerInfo): SVGGElement {
  const motion = machine.states.find((state) => state.name === name);
  const facts = motion
    ? `${motion.motion ?? "no motion"}, ${motion.duration.toFixed(2)} s${motion.loop ? ", loops" : ""}`
    : "";
  const box = svg("rect", { x: x - width / 2, y: y - STATE_HEIGHT / 2, width, height: STATE_HEIGHT, rx: 8 });
  const text = svg(
    "text",
    { x, y: y + 4, "text-anchor": "middle" },
    name.length > 19 ? `${name.slice(0, 18)}…` : name,
  );
  return svg(
    "g",
    { class: name === machine.initial ? "state initial" : "state", "data-state": name },
    svg("title", {}, `${name}: ${facts}; double click: go there`),
    box,
    text,
  );
}

class GraphPanel {
  private readonly canvas = svg("svg", {
    role: "img",
    "aria-label": "state graph",
    preserveAspectRatio: "xMidYMid meet",
  });
  private states = new Map<string, SVGGElement>();
  private edges = new Map<string, SVGGElement>();
  private leaving = new Map<string, SVGGElement[]>();
  private readonly note = el("p", { class: "graph-note" });
  private aspect = 0;
  /** The state whose neighbours are drawn, or null if the whole graph is drawn. */
  private drawnFor: string | null = null;

  constructor(
    private readonly host: HTMLElement,
    private readonly app: App,
  ) {
    host.append(this.canvas, this.note);
    for (const kind of ["contextmenu", "dblclick"])
      this.canvas.addEventListener(kind, (click) => this.wished(click));
    app.machine.info.subscribe(() => this.draw());
    app.selection.layer.subscribe(() => this.draw());
    app.selection.layerStates.subscribe(() => this.mark());
    app.session.verdicts.on((verdict) => this.fire(verdict));
    new ResizeObserver(() => this.fit()).observe(host);
  }

  /** Travels to a state on double click or right click, in the base layer only. */
  private wished(click: Event): void {
    const state =
      click.target instanceof Element
        ? click.target.closest<SVGGElement>(".state")?.dataset["state"]
        : undefined;
    if (state === undefined || this.app.selection.layer.value !== 0) return;
    click.preventDefault();
    void this.app.travel.go(state);
  }

  private fit(): void {
    const { width, height } = this.host.getBoundingClientRect();
    const aspect = width && height ? width / height : 0;
    if (!aspect || Math.abs(aspect - this.aspect) < this.aspect * 0.15) return;
    this.aspect = aspect;
    this.draw();
  }

  private draw(): void {
    const machine = this.app.machine.layerInfo;
    if (!machine || !this.aspect) return;
    const all = machine.states.map((state) => state.name);
    const names = statesToDraw(all, machine.edges, this.app.selection.shownState);
    this.drawnFor = names.length < all.length ? this.app.selection.shownState : null;
    say(this.note, this.drawnFor === null ? "" : `${names.length} of ${all.length} states`);
    const shown = new Set(names);
    const layout = layoutGraph(
      names,
      machine.edges.filter(({ from, to }) => shown.has(from) && shown.has(to)),
      this.aspect,
    );
    this.canvas.classList.toggle("dense", layout.dense);
    this.edges = new Map(layout.edges.map((edge) => [edgeKey(edge.from, edge.to), drawEdge(edge)]));
    this.states = new Map(layout.states.map((state) => [state.name, drawState(state, machine)]));
    this.leaving = new Map(
      names.map((name) => [
        name,
        layout.edges.filter(({ from }) => from === name).map(({ to }) => this.edges.get(edgeKey(name, to))!),
      ]),
    );
    this.canvas.replaceChildren(arrowHead(), ...this.edges.values(), ...this.states.values());
    this.place();
    this.mark();
  }

  /** Fits the drawing with its arrows into the panel, without enlarging it. */
  private place(): void {
    const drawn = this.canvas.getBBox();
    const box = this.host.getBoundingClientRect();
    const [w, h] = [
      Math.max(drawn.width + 2 * MARGIN, box.width),
      Math.max(drawn.height + 2 * MARGIN, box.height),
    ];
    this.canvas.setAttribute(
      "viewBox",
      `${drawn.x + (drawn.width - w) / 2} ${drawn.y + (drawn.height - h) / 2} ${w} ${h}`,
    );
  }

  private mark(): void {
    const live = this.app.selection.shownState;
    // Another state has other neighbours.
    if (this.drawnFor !== null && this.drawnFor !== live && live) return this.draw();
    for (const [name, group] of this.states) group.classList.toggle("live", name === live);
    for (const group of this.edges.values()) group.classList.remove("near");
    for (const group of this.leaving.get(live) ?? []) {
      group.classList.add("near");
      // Moved to the end, the edge is drawn over the others.
      this.states.values().next().value?.before(group);
    }
  }

  private fire({ verdict, event, layer, from, to }: Verdict): void {
    if (verdict !== "taken" || !from || layer !== this.app.selection.layer.value) return;
    const group = this.edges.get(edgeKey(from, to || from));
    if (!group) return;
    flash(group, "fired");
    say(group.querySelector("text")!, event);
    group.parentElement?.querySelectorAll(".last").forEach((old) => old.classList.remove("last"));
    group.classList.add("last");
  }
}

export function graphPanel(host: HTMLElement, app: App): void {
  new GraphPanel(host, app);
}
