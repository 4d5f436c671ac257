/** Loads a character's model.glb once for all its actors. */

import * as THREE from "three";
import { GLTFLoader, type GLTFParser } from "three/examples/jsm/loaders/GLTFLoader.js";
import { dressStroke, isStroke } from "./bodies";
import { skinEnds } from "./boneEnds";
import { type DetailLevel, readDetail } from "./collapses";

export interface Model {
  url: string;
  scene: THREE.Group;
  /** The clips, as the file has them. */
  animations: readonly THREE.AnimationClip[];
  /** The object of every node of the file, by index. */
  nodes: THREE.Object3D[];
  /** Morph targets of every node, by index (0 for most). */
  targets: number[];
  /** The materials in use, by the file's index. */
  materials: Map<number, THREE.Material>;
  materialCount: number;
  /** Nodes that are joints of a skin. */
  skinJoints: Set<number>;
  /** The end of each node's skin, in the node's space. */
  skinEnds: Map<THREE.Object3D, THREE.Vector3>;
  /** Of detail, finest first; the full skin is not among them. */
  levels: readonly DetailLevel[];
  /** Why a sign stands in the model's place. */
  wrong?: string;
}

interface GltfJson {
  nodes?: { mesh?: number }[];
  meshes?: { primitives: { targets?: unknown[]; material?: number }[] }[];
  skins?: { joints: number[] }[];
  materials?: unknown[];
}

function targetCounts(json: GltfJson): number[] {
  const ofMesh = (json.meshes ?? []).map((mesh) => mesh.primitives[0]?.targets?.length ?? 0);
  return (json.nodes ?? []).map((node) => (node.mesh === undefined ? 0 : (ofMesh[node.mesh] ?? 0)));
}

function materialsByIndex(parser: GLTFParser): Map<number, THREE.Material> {
  const found = new Map<number, THREE.Material>();
  // three's default material has no index in the file.
  for (const [object, place] of parser.associations as Map<object, { materials?: number } | undefined>) {
    if (object instanceof THREE.Material && place?.materials !== undefined)
      found.set(place.materials, object as THREE.Material);
  }
  return found;
}

/** Gives lines and points a size, and a colour if the file gives them no material. */
function dressStrokes(scene: THREE.Object3D, parser: GLTFParser, json: GltfJson): void {
  scene.traverse((object) => {
    if (!isStroke(object)) return;
    const { meshes = -1, primitives = -1 } = parser.associations.get(object) ?? {};
    dressStroke(object, json.meshes?.[meshes]?.primitives[primitives]?.material === undefined);
  });
}

// The page normalises weights itself, over all sets of influences (`influences.ts`).
THREE.SkinnedMesh.prototype.normalizeSkinWeights = () => undefined;

/** Loads and parses the model at `url`; rejects with the loader's reason, also if `manager` is told to abort. */
export async function loadModel(url: string, manager = THREE.DefaultLoadingManager): Promise<Model> {
  const gltf = await new GLTFLoader(manager).loadAsync(url);
  const json = gltf.parser.json as GltfJson;
  const count = json.nodes?.length ?? 0;
  const nodes = (await Promise.all(
    Array.from({ length: count }, (_, i) => gltf.parser.getDependency("node", i)),
  )) as THREE.Object3D[];
  dressStrokes(gltf.scene, gltf.parser, json);
  const skinJoints = new Set((json.skins ?? []).flatMap((skin) => skin.joints));
  const materials = { materials: materialsByIndex(gltf.parser), materialCount: json.materials?.length ?? 0 };
  return {
    url,
    scene: gltf.scene,
    animations: gltf.animations,
    nodes,
    targets: targetCounts(json),
    skinJoints,
    skinEnds: skinEnds(gltf.scene),
    levels: await readDetail(gltf.parser, gltf.scene),
    ...materials,
  };
}

/** Models by address, each fetched once. */
export class Models {
  private loads = new Map<string, Promise<Model>>();

  get(url: string): Promise<Model> {
    const known = this.loads.get(url);
    if (known) return known;
    const load = loadModel(url);
    this.loads.set(url, load);
    load.catch(() => this.loads.delete(url));
    return load;
  }
}

/** Finds a material of several models by its index among all their materials; a name must agree. */
export function materialOf(
  models: Iterable<Model>,
  index: number,
  name: string | undefined,
): THREE.Material | undefined {
  let first = 0;
  for (const model of models) {
    const own = model.materials.get(index - first);
    if (own && (!name || own.name === name)) return own;
    first += model.materialCount;
  }
  return undefined;
}
