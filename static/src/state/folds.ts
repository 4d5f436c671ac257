/** Which sub-machines are folded: table and graph show a line and a box for each, in place of its states. */

import { computed, signal } from "@preact/signals-core";
import type { LayerInfo } from "../net/protocol";
import { keep, kept } from "./kept";
import type { WatchedMachine } from "./watchedMachine";

type Layer = Pick<LayerInfo, "states" | "composites">;

const PLACE = "statwalk.folds";
/** How many folded sub-machines, of all machines, this browser keeps. */
const MOST_KEPT = 200;

const isNames = (value: unknown): value is readonly string[] =>
  Array.isArray(value) && value.every((name) => typeof name === "string");

export class Folds {
  private readonly keys = signal(kept(PLACE, isNames, []));
  /** The sub-machines of the shown layer. */
  readonly all = computed(() => this.machine.layerInfo?.composites.map(({ name }) => name) ?? []);
  /** The folded ones of the shown layer. */
  readonly names = computed<ReadonlySet<string>>(
    () => new Set(this.all.value.filter((name) => this.keys.value.includes(this.key(name)))),
  );
  /** What stands for each state of the shown layer. */
  readonly shown = computed(() => {
    const layer = this.machine.layerInfo;
    return layer ? standIns(layer, this.names.value) : new Map<string, string>();
  });

  constructor(private readonly machine: WatchedMachine) {}

  /** Folds some sub-machines of the shown layer, or unfolds them. */
  fold(names: readonly string[], isFolded: boolean): void {
    const changed = new Set(names.map((name) => this.key(name)));
    const others = this.keys.value.filter((key) => !changed.has(key));
    this.keys.value = [...others, ...(isFolded ? changed : [])].slice(-MOST_KEPT);
    keep(PLACE, this.keys.value);
  }

  /** Folds all sub-machines of the shown layer, or unfolds them if one is folded. */
  toggleAll(): void {
    this.fold(this.all.value, this.names.value.size === 0);
  }

  /** Unfolds what hides a state. */
  reveal(state: string): void {
    const layer = this.machine.layerInfo;
    if (layer && this.shown.value.get(state) !== state) this.fold(around(layer, state), false);
  }

  private key(name: string): string {
    return JSON.stringify([this.machine.info.value?.name, this.machine.layerInfo?.name, name]);
  }
}

/** Returns the sub-machines around a state or a sub-machine, from inside out. */
export function around(layer: Layer, name: string): string[] {
  const outer = [...layer.states, ...layer.composites].find((other) => other.name === name)?.outer ?? "";
  return outer ? [outer, ...around(layer, outer)] : [];
}

/** Returns for each state the outermost folded sub-machine around it, or the state itself. */
export function standIns(layer: Layer, folded: ReadonlySet<string>): Map<string, string> {
  return new Map(
    layer.states.map(({ name }) => [
      name,
      around(layer, name)
        .filter((outer) => folded.has(outer))
        .at(-1) ?? name,
    ]),
  );
}
