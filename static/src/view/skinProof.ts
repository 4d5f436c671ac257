/** Proves the GPU's skin: the largest distance between its vertices of the watched actor and the server's. */

import * as THREE from "three";
import { chunksOf, layoutOf, view } from "../net/glb";
import { frameFile } from "../net/api";
import type { Skinning } from "../net/protocol";
import { reasonOf } from "../net/reason";
import type { State } from "../state/state";
import { signal } from "@preact/signals-core";
import type { Crowd } from "./crowd";
import { worldOf } from "./glbStage";
import { readVertices } from "./skinReadback";
import { type ServerPrimitive, largestDifference } from "./vertexDifference";

/** Reads the primitives of a stage's frame, actor by actor. */
function primitivesOf(file: ArrayBuffer): ServerPrimitive[] {
  const chunks = chunksOf(file);
  const layout = layoutOf(chunks);
  return layout.primitives.map(({ node, positions, indices }) => {
    const own = view(chunks.bin, positions);
    const world = worldOf(layout, node);
    const [places, place] = [new Float64Array(own.length), new THREE.Vector3()];
    for (let at = 0; at < own.length; at += 3)
      place.fromArray(own, at).applyMatrix4(world).toArray(places, at);
    return { places, order: indices && view(chunks.bin, indices) };
  });
}

export class SkinProof {
  readonly on = signal(false);
  /** The largest distance of the last compared frame, metres; or why there is none. */
  readonly difference = signal<number | string>("");
  /** Which actor, tick and way of skinning were compared for `difference`. */
  measured: { actor: number; tick: number; way: Skinning } | null = null;
  private busy = false;
  /** What was compared last. */
  private compared = "";

  constructor(
    private readonly renderer: THREE.WebGLRenderer,
    private readonly state: State,
  ) {
    this.on.subscribe(() => {
      this.compared = "";
      this.difference.value = "";
    });
  }

  /** Compares an actor of the drawn frame, if the last comparison is done and the frame is another one. */
  compare(crowds: readonly Crowd[], crowd: Crowd, row: number, tick: number): void {
    const wanted = [this.state.stage.id, tick, crowd.way, crowds.indexOf(crowd), row].join();
    if (!this.on.value || this.busy || wanted === this.compared) return;
    this.compared = wanted;
    const before = crowds.slice(0, crowds.indexOf(crowd));
    const first = before.reduce((all, one) => all + one.cast.actors.length * one.parts.primitives, 0);
    const { way } = crowd;
    const { parts, primitives } = crowd.parts;
    const gpu = parts.map((part) => readVertices(this.renderer, crowd, row, part));
    this.busy = true;
    void frameFile(this.state.stage.id, tick, this.state.frames.skinning.value)
      .then((file) => {
        const from = first + row * primitives;
        const server = primitivesOf(file).slice(from, from + primitives);
        const away = parts.map((part, k) => largestDifference(part, gpu[k]!, server, way));
        this.measured = { actor: crowd.cast.actors[row]!.id, tick, way };
        this.tell(Math.max(0, ...away));
      })
      .catch((error: unknown) => this.tell(reasonOf(error)))
      .finally(() => (this.busy = false));
  }

  /** The server skins in the glb stream. */
  idle(): void {
    this.tell("the server skins: there is nothing to compare");
  }

  private tell(difference: number | string): void {
    if (this.on.value) this.difference.value = difference;
  }
}
