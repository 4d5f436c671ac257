/** Shows the watched machine's graph: what is drawn, where it stands, what is selected and pointed at. */

import { effect } from "@preact/signals-core";
import type { LayerInfo, MachineInfo, Verdict } from "../../net/protocol";
import type { App } from "../../view/app";
import { Camera } from "./camera";
import { type Content, folded, partOf, withFolded } from "./content";
import { deletePlaces, keepPlace } from "./graphEdits";
import { LayerPlaces } from "./layerPlaces";
import { Picture } from "./picture";
import { placeStates } from "./places";
import { type Places, type Point, type Size, rectOf } from "./shapes";

/** Milliseconds without a zoom after which labels look for new places. */
const SETTLED_MS = 120;

interface Drawn {
  machine: MachineInfo;
  layer: LayerInfo;
  /** What stands for each state. */
  shown: ReadonlyMap<string, string>;
  /** Around which state, or by which words of the filter, a part is drawn; "": all is drawn. */
  part: string;
}

export class GraphView {
  readonly picture = new Picture();
  readonly camera = new Camera(this.picture.canvas, this.picture.world);
  /** Where the drawn states stand. */
  places: Places = new Map();
  private readonly layerPlaces = new LayerPlaces();
  private drawn: Drawn | null = null;
  private lit = "";
  private settling: ReturnType<typeof setTimeout> | undefined;

  constructor(
    host: HTMLElement,
    private readonly app: App,
    private readonly note: (words: string) => void,
  ) {
    host.append(this.picture.canvas);
    this.camera.changed.on((zoom) => this.zoomed(zoom));
    effect(() => this.changed());
    effect(() => this.mark());
    app.session.verdicts.on((verdict) => this.fire(verdict));
    app.session.leaving.on(() => host.querySelector(".edge.last")?.classList.remove("last"));
    new ResizeObserver(() => this.resized()).observe(host);
  }

  /** Whether only a part of a large machine is drawn: then places are not kept. */
  get isPart(): boolean {
    return this.drawn !== null && this.drawn.part !== "";
  }

  fit(): void {
    const { bounds } = this.picture;
    if (bounds) this.camera.fit(bounds);
  }

  /** Selects a state, or the arrow of an event; of the arrows that leave a folded sub-machine the first. */
  select(name: string | null, event: string | null = null): void {
    const layer = this.app.machine.layerInfo;
    const leaves = layer?.edges.find(
      ({ from, events }) => this.standIn(from) === name && event !== null && events.includes(event),
    );
    const state = leaves?.from ?? name;
    this.app.inspection.selected.value =
      state === null || !layer ? null : { layer: layer.name, state, event };
  }

  isFolded(name: string): boolean {
    return this.app.folds.names.value.has(name);
  }

  /** Unfolds a sub-machine. */
  unfold(name: string): void {
    this.app.folds.fold([name], false);
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

  /** Lays the graph out anew. Deletes the places of states from the file, unless only a part of the graph is drawn. */
  async arrange(): Promise<void> {
    if (!this.isPart && !(await deletePlaces(this.app))) return;
    const [machine, layer] = [this.app.machine.info.value, this.app.machine.layerInfo];
    if (machine && layer) this.layerPlaces.forget(machine, layer);
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

  /** The size of the panel; null while it is hidden. */
  private get room(): Size | null {
    const { width, height } = this.picture.canvas.getBoundingClientRect();
    return width && height ? { width, height } : null;
  }

  /**
   * Draws another machine with the next frame, when all panels have their size, and a large one, so that one frame has
   * not all the work of an edit; an edit of another one at once.
   */
  private changed(): void {
    const [machine, layer, live] = [this.app.machine.info.value, this.app.machine.layerInfo, this.live];
    const isFiltered = this.app.nameFilter.text.value !== "";
    const known = machine?.name === this.drawn?.machine.name && layer?.name === this.drawn?.layer.name;
    if ((known && !this.isPart && !isFiltered) || !live) this.draw();
    else requestAnimationFrame(() => this.draw());
  }

  private draw(): void {
    const [machine, layer] = [this.app.machine.info.value, this.app.machine.layerInfo];
    const { live } = this;
    if (!machine || !layer) return;
    const shown = this.app.folds.shown.value;
    const all = folded(layer, shown);
    const words = this.app.nameFilter.text.value;
    const content = partOf(all, live, words);
    const part = content.nodes.length < all.nodes.length ? words || live : "";
    const { drawn } = this;
    const isSame = drawn?.machine === machine && drawn.layer === layer && drawn.shown === shown;
    const { room } = this;
    if ((isSame && drawn.part === part) || !room) return;
    this.drawn = { machine, layer, shown, part };
    this.picture.room = room;
    this.note(part ? `${content.nodes.length} of ${all.nodes.length} states` : "");
    const isHere = drawn?.layer.name === layer.name && drawn.machine.name === machine.name;
    // An edit moves nothing, and a whole layout takes long.
    const kept: Places = isHere && drawn.part === part ? this.places : new Map<string, Point>();
    this.places = part
      ? placeStates(
          content.nodes.map(({ name }) => name),
          content.edges,
          kept,
          room,
        )
      : withFolded(this.layerPlaces.of(machine, layer, room), content.nodes);
    this.show(content);
    if (!isHere || part || this.camera.fitted) this.fit();
    this.mark();
  }

  private standIn(state: string): string {
    return this.app.folds.shown.value.get(state) ?? state;
  }

  /** What stands for the live state. */
  private get live(): string {
    return this.standIn(this.app.selection.shownState);
  }

  private show(content: Content): void {
    const focused = document.activeElement?.closest<SVGElement>("#graph .state")?.dataset["state"];
    this.picture.show(content, this.places);
    const element = this.picture.stateElement(focused ?? content.initial);
    if (element) this.rove(element);
    if (focused !== undefined) this.focus(focused);
  }

  private mark(): void {
    const { live } = this;
    const selected = this.app.inspection.selected.value;
    const layer = this.app.machine.layerInfo;
    const isHere = selected !== null && selected.layer === layer?.name;
    const arrow = layer?.edges.find(
      ({ from, events }) => from === selected?.state && events.includes(selected.event ?? ""),
    );
    this.picture.mark({
      live,
      lit: this.lit,
      selected: isHere
        ? { state: this.standIn(selected.state), event: selected.event, to: this.standIn(arrow?.to ?? "") }
        : null,
    });
  }

  private zoomed(zoom: number): void {
    this.picture.zoomed(zoom);
    clearTimeout(this.settling);
    this.settling = setTimeout(() => this.picture.write(), SETTLED_MS);
  }

  private resized(): void {
    this.picture.room = this.room ?? this.picture.room;
    if (!this.drawn) this.draw();
    else if (this.camera.fitted) this.fit();
  }

  private fire({ verdict, event, layer, from, to }: Verdict): void {
    if (verdict === "taken" && from && layer === this.app.selection.layer.value)
      this.picture.fire(this.standIn(from), this.standIn(to || from), event);
  }
}
