/** The casts of the stage that is shown: their models are loaded, and their actors stand on it. */

import type { CastHello, Hello } from "../net/protocol";
import { reasonOf } from "../net/reason";
import type { State } from "../state/state";
import { signal } from "@preact/signals-core";
import { Event } from "../state/event";
import { CastView } from "./castView";
import type { DetailChoice } from "./detailChoice";
import { missingModel } from "./missing";
import { type Model, Models } from "./model";
import { PosedModel } from "./posedModel";
import type { Scene } from "./scene";

/** What a hello says of machines; the rest is what is drawn. */
const OF_MACHINES: ReadonlySet<string> = new Set(["version", "layers", "states", "state_layers", "events"]);

/** Returns what is drawn of a hello: an edit of a machine changes none of it. */
function drawnOf({ stage, casts }: Hello): string {
  return JSON.stringify([stage, casts], (name, value: unknown) =>
    OF_MACHINES.has(name) ? undefined : value,
  );
}

export class Casting {
  casts: readonly CastView[] = [];
  readonly actors = new Map<number, PosedModel>();
  readonly loading = signal<string>("");
  /** The actors of the stage before have left. */
  readonly cleared = new Event<void>();
  /** All actors stand on the stage. */
  readonly built = new Event<void>();
  private readonly models = new Models();
  private generation = 0;
  /** What is drawn, or loaded for it. */
  private shown = "";

  constructor(
    private readonly scene: Scene,
    private readonly state: State,
    private readonly detail: DetailChoice,
  ) {}

  /** Loads the models of a hello and puts its actors on the stage. */
  async take(hello: Hello): Promise<void> {
    const wanted = drawnOf(hello);
    if (wanted === this.shown) return;
    this.shown = wanted;
    const generation = ++this.generation;
    this.clear();
    this.loading.value = "loading the character";
    try {
      const models = await Promise.all(hello.casts.map((cast) => this.modelOf(cast)));
      if (generation !== this.generation) return;
      this.build(hello, models);
      const wrong = models.find((model) => model.wrong)?.wrong;
      this.loading.value = "";
      if (wrong) this.state.notices.emit(wrong);
      if (wrong) this.shown = ""; // the next hello tries again
    } catch (error) {
      if (generation !== this.generation) return;
      this.shown = "";
      this.loading.value = `The stage cannot be shown: ${reasonOf(error)}`;
    }
  }

  /** Takes the stage off the picture. */
  leave(): void {
    this.generation++;
    this.shown = "";
    this.clear();
  }

  /** Loads a cast's model; a model that fails says so where it would stand. */
  private modelOf({ model, machine }: CastHello): Promise<Model> {
    const url = new URL(model, document.baseURI).href;
    return this.models
      .get(url)
      .catch((error: unknown) =>
        missingModel(url, `The model of ${machine} cannot be loaded: ${reasonOf(error)}`),
      );
  }

  /** Takes the actors off the stage. */
  private clear(): void {
    for (const cast of this.casts) cast.dispose();
    this.casts = [];
    this.actors.clear();
    this.cleared.emit(undefined);
  }

  private build(hello: Hello, models: Model[]): void {
    this.casts = hello.casts.map((cast, c) => new CastView(cast, models[c]!, this.scene));
    for (const { cast, crowd } of this.casts) {
      crowd.levelAt = (distance_m, camera) =>
        this.detail.levelAt(crowd.model.levels, distance_m, camera, this.scene.canvas.height);
      cast.actors.forEach(({ id }, row) => this.actors.set(id, new PosedModel(id, crowd, row)));
    }
    this.built.emit(undefined);
  }
}
