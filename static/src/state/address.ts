/** What the page's address says: the stage, and what is looked at there, from where, and when. */

import type { Opening } from "./ownStages";
import { CAMERA_MODES, type CameraMode } from "./viewpoint";

export interface Address {
  /** Null: main. */
  stage: string | null;
  /** What the stage began with, for the time when it is gone. */
  opening: Opening | null;
  /** Null: the first. */
  actor: number | null;
  /** Null: the base layer. */
  layer: string | null;
  /** Null: the present. */
  tick: number | null;
  /** The tick that is explained; null: none. */
  why: number | null;
  /** Where the camera stands and what it looks at, metres from the actor's root; null: as the page frames it. */
  camera: readonly number[] | null;
  /** What the camera does while the actor moves; null: it follows. */
  view: CameraMode | null;
}

const CAMERA_NUMBERS = 6;

/** Returns the whole number that a text is, or null. */
const countOf = (text: string | null): number | null =>
  text && /^\d{1,9}$/.test(text) ? Number(text) : null;

function cameraOf(text: string | null): readonly number[] | null {
  const numbers = (text ?? "").split(",").map(Number);
  return text && numbers.length === CAMERA_NUMBERS && numbers.every(Number.isFinite) ? numbers : null;
}

function openingOf(query: URLSearchParams): Opening | null {
  const [machine, scene] = [query.get("machine"), query.get("scene")];
  return machine ? { machine } : scene ? { scene } : null;
}

/** Reads an address; what is wrong in it counts as left out. */
export function readAddress(search: string = location.search): Address {
  const query = new URLSearchParams(search);
  return {
    stage: query.get("stage"),
    opening: openingOf(query),
    actor: countOf(query.get("actor")),
    layer: query.get("layer"),
    tick: countOf(query.get("tick")),
    why: countOf(query.get("why")),
    camera: cameraOf(query.get("camera")),
    view: CAMERA_MODES.find((mode) => mode === query.get("view")) ?? null,
  };
}

/** Returns the page's address with these parts in place of its own; its other parts stay. */
export function addressWith({ opening, camera, ...plain }: Address): URL {
  const address = new URL(location.href);
  const parts = {
    ...{ machine: null, scene: null, ...opening },
    ...plain,
    camera: camera?.map((metres) => metres.toFixed(2)).join(",") ?? null,
  };
  for (const [name, value] of Object.entries(parts)) {
    if (value === null) address.searchParams.delete(name);
    else address.searchParams.set(name, String(value));
  }
  return address;
}
