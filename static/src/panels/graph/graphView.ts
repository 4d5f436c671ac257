/** Shows the watched machine's graph: what is drawn, where it stands, what is selected and pointed at. */

import { effect } from "@preact/signals-core";
import type { LayerInfo, MachineInfo, Verdict } from "../../net/protocol";
import type { App } from "../../view/app";
import { Camera } from "./camera";
import { keepPlace } from "./graphEdits";
import { LayerPlaces } from "./layerPlaces";
import type { Places } from "./layout";
import { statesToDraw } from "./neighbours";
import { placeStates } from "./places";
import { type Content, Picture } from "./picture";
import { type Point, rectOf } from "./shapes";

/** Milliseconds without a zoom after which labels look for new places. */
const SETTLED_MS = 120;

export class GraphView {
  readonly picture = new Picture();
  readonly camera = new Camera(this.picture.canvas, this.picture.world);
  /** Where the drawn states stand. */
  places: Places = new Map();
  private readonly layerPlaces = new LayerPlaces();
  private drawn: { machine: MachineInfo; layer: LayerInfo; around: string } | null = null;
  private lit = "";
  private settling: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly host: HTMLElement,
    private readonly app: App,
    private readonly note: (words: string) => void,
  ) {
    host.append(this.picture.canvas);
    this.camera.changed.on((zoom) => this.zoomed(zoom));
    effect(() => this.changed());
    effect(() => this.mark());
    app.session.verdicts.on((verdict) => this.fire(verdict));
    new ResizeObserver(() => this.resized()).observe(host);
  }

  /** Whether only a part of a large machine is drawn: then places are not kept. */
  get isPart(): boolean {
    return this.drawn !== null && this.drawn.around !== "";
  }

  fit(): void {
    const { bounds } = this.picture;
    if (bounds) this.camera.fit(bounds);
  }

  select(state: string | null, event: string | null = null): void {
    const layer = this.app.machine.layerInfo?.name;
    this.app.inspection.selected.value =
      state === null || layer === undefined ? null : { layer, state, event };
  }

  /** Lights a state's arrows; "": none. */
  light(state: string): void {
    if (state === this.lit) return;
    this.lit = state;
    this.mark();
  }

  /** Moves the keyboard's focus to a state, and the state into sight. */
  focus(state: string): void {
    const [element, box] = [this.picture.stateElement(state), this.picture.box(state)];
    if (!element || !box) return;
    this.rove(element);
    this.camera.reveal(rectOf(box, 12));
    element.focus({ preventScroll: true });
  }

  move(state: string, place: Point): void {
    this.places.set(state, place);
    this.picture.move(state, place);
  }

  /** Keeps the place of a moved state; if it is refused, the state goes back. */
  async keep(state: string): Promise<void> {
    if (await keepPlace(this.app, state, this.places)) return;
    this.drawn = null;
    this.draw();
  }

  /** Makes `element` the one that Tab reaches. */
  rove(element: SVGElement): void {
    this.picture.canvas
      .querySelectorAll("[tabindex='0']")
      .forEach((old) => old.setAttribute("tabindex", "-1"));
    element.setAttribute("tabindex", "0");
  }

  private get aspect(): number {
    const { width, height } = this.host.getBoundingClientRect();
    return width && height ? width / height : 0;
  }

  /** Draws another machine with the next frame, when all panels have their size; an edit at once. */
  private changed(): void {
    const [machine, layer, live] = [
      this.app.machine.info.value,
      this.app.machine.layerInfo,
      this.app.selection.shownState,
    ];
    const known = machine?.name === this.drawn?.machine.name && layer?.name === this.drawn?.layer.name;
    if (known || !live) this.draw();
    else requestAnimationFrame(() => this.draw());
  }

  private draw(): void {
    const [machine, layer] = [this.app.machine.info.value, this.app.machine.layerInfo];
    const live = this.app.selection.shownState;
    if (!machine || !layer || !this.aspect) return;
    const names = statesToDraw(
      layer.states.map(({ name }) => name),
      layer.edges,
      live,
    );
    const around = names.length < layer.states.length ? live : "";
    const { drawn } = this;
    if (drawn?.machine === machine && drawn.layer === layer && drawn.around === around) return;
    this.drawn = { machine, layer, around };
    this.note(around ? `${names.length} of ${layer.states.length} states` : "");
    const content = part(layer, names);
    const isHere = drawn?.layer.name === layer.name && drawn.machine.name === machine.name;
    // An edit moves nothing, and a whole layout takes long.
    const kept: Places = isHere && drawn.around === around ? this.places : new Map<string, Point>();
    this.places = around
      ? placeStates(names, content.edges, kept, this.aspect)
      : this.layerPlaces.of(machine, layer, this.aspect);
    this.show(content);
    if (!isHere || around || this.camera.fitted) this.fit();
  }

  private show(content: Content): void {
    const focused = document.activeElement?.closest<SVGElement>("#graph .state")?.dataset["state"];
    this.picture.show(content, this.places);
    const element = this.picture.stateElement(focused ?? content.initial);
    if (element) this.rove(element);
    if (focused !== undefined) this.focus(focused);
  }

  private mark(): void {
    const live = this.app.selection.shownState;
    const selected = this.app.inspection.selected.value;
    const layer = this.app.machine.layerInfo;
    const isHere = selected !== null && selected.layer === layer?.name;
    const arrow = layer?.edges.find(
      ({ from, events }) => from === selected?.state && events.includes(selected.event ?? ""),
    );
    this.picture.mark({
      live,
      lit: this.lit,
      selected: isHere ? { ...selected, to: arrow?.to ?? "" } : null,
    });
  }

  private zoomed(zoom: number): void {
    this.picture.zoomed(zoom);
    clearTimeout(this.settling);
    this.settling = setTimeout(() => this.picture.write(), SETTLED_MS);
  }

  private resized(): void {
    if (!this.drawn) this.draw();
    else if (this.camera.fitted) this.fit();
  }

  private fire({ verdict, event, layer, from, to }: Verdict): void {
    if (verdict === "taken" && from && layer === this.app.selection.layer.value)
      this.picture.fire(from, to || from, event);
  }
}

function part({ states, edges, initial }: LayerInfo, names: readonly string[]): Content {
  const shown = new Set(names);
  return {
    states: states.filter(({ name }) => shown.has(name)),
    edges: edges.filter(({ from, to }) => shown.has(from) && shown.has(to)),
    initial,
  };
}
