/** A model that moves by its own clips, before it has a machine: what the page shows of a dropped file. */

import * as THREE from "three";
import { computed, signal } from "@preact/signals-core";
import { type Body, isBody } from "./bodies";
import { influences } from "./influences";
import type { Model } from "./model";

/** A mesh that can be hidden. */
export interface LookedMesh {
  name: string;
  triangles: number;
  object: Body;
  /** NODE/PRIMITIVE: the numbers of both in the file, which tell meshes of the same name apart. */
  place: string;
}

/** Returns the number of triangles; of lines and points: none. */
function trianglesOf(object: Body): number {
  const { index, attributes } = object.geometry;
  return object instanceof THREE.Mesh
    ? Math.floor((index?.count ?? attributes["position"]?.count ?? 0) / 3)
    : 0;
}

/** Returns the file's name of an object: three takes signs out of `name`. */
const nameOf = ({ name, userData, type }: THREE.Object3D): string =>
  typeof userData["name"] === "string" ? userData["name"] : name || type;

/** Returns NODE/PRIMITIVE: a node of several primitives has an object for each below it, in their order. */
function placeOf(object: THREE.Object3D, numbers: ReadonlyMap<THREE.Object3D, number>): string {
  let node = object;
  while (!numbers.has(node) && node.parent) node = node.parent;
  const primitive = node === object ? 0 : object.parent!.children.indexOf(object);
  return `${numbers.get(node)}/${primitive}`;
}

function drawnIn({ scene, nodes }: Model): LookedMesh[] {
  const meshes: LookedMesh[] = [];
  const numbers = new Map(nodes.map((node, number) => [node, number]));
  scene.traverse((object) => {
    if (!isBody(object)) return;
    const place = placeOf(object, numbers);
    meshes.push({ name: nameOf(object), triangles: trianglesOf(object), object, place });
  });
  return meshes;
}

/**
 * Prepares a mesh for the page's own skinning (`skinShader.ts`): the page has taken three's normalising away, and
 * bones carry vertices to the world, whatever the transform of the mesh's node; morph weights are the mesh's.
 */
function prepareSkin({ object }: LookedMesh): void {
  if (!(object instanceof THREE.SkinnedMesh)) return;
  object.onBeforeRender = () => void object.matrixWorld.identity();
  const { geometry, material } = object as THREE.SkinnedMesh;
  for (const each of [material].flat()) each.defines = { ...each.defines, OWN_WEIGHTS: "" };
  for (const [name, values] of Object.entries(influences(geometry, 0).attributes))
    geometry.setAttribute(name, values);
}

export class LookedModel {
  readonly meshes: readonly LookedMesh[];
  readonly hidden = signal<ReadonlySet<LookedMesh>>(new Set());
  /** The clips that play, by index. */
  readonly playing = signal<ReadonlySet<number>>(new Set());
  readonly paused = signal(false);
  readonly loops = signal(true);
  /** Whether a clip that begins ends the others. */
  readonly solo = signal(true);
  readonly speed = signal(1);
  /** Seconds into the clip that was begun last. */
  readonly time = signal(0);
  /** Weights that the user has set: they win over the clips. */
  readonly weights = signal<Readonly<Record<string, number>>>({});
  /** The names of the morph targets. */
  readonly targets: readonly string[];
  /** Seconds that the clip lasts that was begun last; 0: none plays. */
  readonly duration = computed(() => this.clip([...this.playing.value].at(-1))?.duration ?? 0);
  private readonly mixer: THREE.AnimationMixer;

  constructor(private readonly model: Model) {
    this.meshes = drawnIn(model);
    this.meshes.forEach(prepareSkin);
    const targets = this.meshes.flatMap(({ object }) => Object.keys(object.morphTargetDictionary ?? {}));
    this.targets = [...new Set(targets)];
    this.mixer = new THREE.AnimationMixer(model.scene);
    model.scene.updateMatrixWorld(true);
  }

  /** The number of clips. */
  get clips(): number {
    return this.model.animations.length;
  }

  private clip(index: number | undefined): THREE.AnimationClip | undefined {
    return index === undefined ? undefined : this.model.animations[index];
  }

  private action(index: number): THREE.AnimationAction {
    return this.mixer.clipAction(this.clip(index)!);
  }

  /** Begins a clip, or ends it. */
  toggle(index: number): void {
    const ends = this.playing.value.has(index);
    const kept = [...this.playing.value].filter((other) => other !== index && (ends || !this.solo.value));
    const next = new Set(ends ? kept : [...kept, index]);
    for (const other of this.playing.value) if (!next.has(other)) this.action(other).stop();
    this.playing.value = next;
    this.paused.value = false;
    if (!ends) this.begin(index);
    this.pose();
  }

  private begin(index: number): void {
    const action = this.action(index).reset();
    action.setLoop(this.loops.value ? THREE.LoopRepeat : THREE.LoopOnce, Infinity);
    action.clampWhenFinished = true;
    action.play();
  }

  /** Lets the clips begin again at their end, or stay there. */
  setLoop(loops: boolean): void {
    this.loops.value = loops;
    for (const index of this.playing.value) this.begin(index);
  }

  /** Shows the moment `time` of all clips, and pauses. */
  seek(time: number): void {
    this.paused.value = true;
    for (const index of this.playing.value) {
      const action = this.action(index);
      Object.assign(action, { time: Math.min(time, action.getClip().duration), paused: false });
    }
    this.pose();
  }

  hide(mesh: LookedMesh, hidden: boolean): void {
    const others = [...this.hidden.value].filter((other) => other !== mesh);
    this.hidden.value = new Set(hidden ? [...others, mesh] : others);
    // Meshes below a hidden one in the tree stay.
    mesh.object.layers.set(hidden ? 1 : 0);
  }

  setWeight(target: string, weight: number): void {
    this.weights.value = { ...this.weights.value, [target]: weight };
    this.pose();
  }

  /** Moves on by `dt` seconds; returns whether anything moved. */
  advance(dt: number): boolean {
    if (this.paused.value || !this.playing.value.size) return false;
    this.pose(dt * this.speed.value);
    return true;
  }

  private pose(dt = 0): void {
    this.mixer.update(dt);
    for (const { object } of this.meshes)
      for (const [target, weight] of Object.entries(this.weights.value)) {
        const index = object.morphTargetDictionary?.[target];
        if (index !== undefined) object.morphTargetInfluences![index] = weight;
      }
    this.model.scene.updateMatrixWorld(true);
    const last = [...this.playing.value].at(-1);
    this.time.value = last === undefined ? 0 : this.action(last).time;
  }
}
