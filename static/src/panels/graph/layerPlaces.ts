/** Remembers where the states of each layer stand; places that the machine's file keeps come first. */

import type { LayerInfo, MachineInfo } from "../../net/protocol";
import { placeStates, renamed } from "./places";
import type { Places, Point, Size } from "./shapes";

interface Remembered {
  names: readonly string[];
  places: ReadonlyMap<string, Point>;
}

export class LayerPlaces {
  private readonly remembered = new Map<string, Remembered>();

  /** Returns the places of a layer's states; `room`: of the panel, for a first layout. */
  of(machine: MachineInfo, layer: LayerInfo, room: Size): Places {
    const names = layer.states.map(({ name }) => name);
    const key = keyOf(machine, layer);
    const before = this.remembered.get(key);
    const kept = before ? renamed(before.places, before.names, names) : new Map<string, Point>();
    const places = placeStates(names, layer.edges, new Map([...kept, ...filed(machine, layer)]), room);
    // A place that only the file has is not remembered as ours: an undo takes it away again.
    this.remembered.set(key, { names, places: new Map([...places, ...kept]) });
    return places;
  }

  /** Forgets the places of a layer's states, so that `of` lays the states out anew. */
  forget(machine: MachineInfo, layer: LayerInfo): void {
    this.remembered.delete(keyOf(machine, layer));
  }
}

const keyOf = (machine: MachineInfo, layer: LayerInfo): string => JSON.stringify([machine.name, layer.name]);

/** Returns the places that the machine's file keeps. */
export function filed({ view }: MachineInfo, { name }: LayerInfo): Map<string, Point> {
  return new Map(Object.entries(view[name] ?? {}).map(([state, [x, y]]) => [state, { x, y }]));
}
