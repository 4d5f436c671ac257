/**
 * Takes a model apart into what a crowd draws: one part for each material, whose vertices follow the matrices
 * of a list. A skin follows its bones; a rigid mesh follows its node.
 */

import * as THREE from "three";
import { mergeGeometries } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import { type Body, isBody } from "./bodies";
import { collapsesOf } from "./collapses";
import { influences } from "./influences";
import type { IndexedPiece } from "./levelIndex";
import type { Model } from "./model";

/** What a vertex can follow: a node of the file, and the matrix (16) from the vertex to the node at rest. */
export interface NodeFollow {
  node: number;
  inverse: readonly number[];
}

/** A primitive of the file, and where its vertices, and the corners of its triangles, are in the part. */
export interface Source extends IndexedPiece {
  /** Among the primitives of the model, in the order of the file's nodes. */
  primitive: number;
  /** Whether its vertices follow bones, not their node. */
  skinned: boolean;
}

export interface Part {
  geometry: THREE.BufferGeometry;
  material: THREE.Material | THREE.Material[];
  /** A body of the model that is drawn in the same way: as triangles, lines or points. */
  like: Body;
  /** The first morph weight of its node in a row of a frame. */
  firstWeight: number;
  sources: Source[];
}

export interface Parts {
  follows: NodeFollow[];
  parts: Part[];
  /** Number of primitives of the model. */
  primitives: number;
  /** The influences of the vertex that has most. */
  most: number;
}

const IDENTITY = new THREE.Matrix4().toArray();

/** Returns what a node's mesh is drawn with, in the order of its primitives. */
function bodiesOf(node: THREE.Object3D, nodes: ReadonlyMap<THREE.Object3D, number>): Body[] {
  if (isBody(node)) return [node];
  // A mesh with several primitives, or on a bone, is in objects below the node's, which are no nodes.
  return node.children.filter((child) => !nodes.has(child)).flatMap((child) => bodiesOf(child, nodes));
}

function isBelow(object: THREE.Object3D, scene: THREE.Object3D): boolean {
  for (let at: THREE.Object3D | null = object; at; at = at.parent) if (at === scene) return true;
  return false;
}

/** Collects what the vertices of a model follow. */
class Follows {
  readonly list: NodeFollow[] = [];
  private readonly firsts = new Map<string, number>();

  constructor(private readonly nodes: ReadonlyMap<THREE.Object3D, number>) {}

  /** Returns the first place of the list for a body: of its node, or of the first bone of its skin. */
  of(body: Body, node: number): number {
    if (!(body instanceof THREE.SkinnedMesh)) return this.add([{ node, inverse: IDENTITY }]);
    const { bones, boneInverses } = body.skeleton;
    return this.add(
      bones.map((bone, k) => ({
        node: this.nodes.get(bone) ?? node,
        inverse: boneInverses[k]!.clone().multiply(body.bindMatrix).toArray(),
      })),
    );
  }

  /** Meshes of one skin share its places. */
  private add(block: NodeFollow[]): number {
    const key = block.map(({ node, inverse }) => `${node}:${inverse.join()}`).join(";");
    const first = this.firsts.get(key) ?? this.list.length;
    if (first === this.list.length) this.list.push(...block);
    this.firsts.set(key, first);
    return first;
  }
}

/** A mirror turns the triangles of a rigid mesh inside out; this turns them back. */
function unmirrored(geometry: THREE.BufferGeometry): THREE.BufferGeometry {
  const count = geometry.index?.count ?? geometry.getAttribute("position").count;
  const order = Array.from({ length: count }, (_, k) => geometry.index?.getX(k) ?? k);
  for (let k = 0; k + 2 < count; k += 3) [order[k + 1], order[k + 2]] = [order[k + 2]!, order[k + 1]!];
  return geometry.setIndex(order);
}

/** Returns a geometry that shares the arrays which a crowd needs. */
function followingGeometry(body: Body, first: number): { geometry: THREE.BufferGeometry; most: number } {
  const own = body.geometry;
  const geometry = new THREE.BufferGeometry();
  for (const [name, attribute] of Object.entries(own.attributes))
    if (!/^(joints|weights)_|^skin/.test(name)) geometry.setAttribute(name, attribute);
  const { attributes, most } = influences(own, first);
  for (const [name, attribute] of Object.entries(attributes)) geometry.setAttribute(name, attribute);
  geometry.setIndex(own.index);
  geometry.morphAttributes = own.morphAttributes;
  geometry.morphTargetsRelative = own.morphTargetsRelative;
  for (const group of own.groups) geometry.addGroup(group.start, group.count, group.materialIndex);
  const mirrored = body instanceof THREE.Mesh && !(body instanceof THREE.SkinnedMesh);
  return { geometry: mirrored && body.matrixWorld.determinant() < 0 ? unmirrored(geometry) : geometry, most };
}

const shape = (attribute: THREE.BufferAttribute | THREE.InterleavedBufferAttribute): string =>
  [attribute.itemSize, attribute.normalized, attribute.array.constructor.name].join();

/** Parts with one key can be drawn at once; a part with morph targets, strips and loops stay alone. */
function keyOf({ geometry, material, like }: Part): string | null {
  const attributes = Object.entries(geometry.attributes);
  const alone =
    Object.keys(geometry.morphAttributes).length > 0 ||
    attributes.some(([, attribute]) => attribute instanceof THREE.InterleavedBufferAttribute) ||
    Array.isArray(material) ||
    !["Mesh", "LineSegments", "Points"].includes(like.type.replace("Skinned", ""));
  if (alone) return null;
  const names = attributes.map(([name, attribute]) => `${name} ${shape(attribute)}`).sort();
  return [material.uuid, like.type.replace("Skinned", ""), geometry.index !== null, ...names].join("/");
}

const cornersOf = (geometry: THREE.BufferGeometry): number =>
  geometry.index?.count ?? geometry.getAttribute("position").count;

/** Puts parts together that share a key. */
function merged(parts: readonly Part[]): Part {
  const [first] = parts as [Part];
  if (parts.length === 1) return first;
  let [vertex, corner] = [0, 0];
  const sources = parts.flatMap(({ sources }) =>
    sources.map((source) => {
      const placed = { ...source, firstVertex: vertex, firstCorner: corner };
      vertex += source.vertices;
      corner += source.corners;
      return placed;
    }),
  );
  return { ...first, geometry: mergeGeometries(parts.map(({ geometry }) => geometry)), sources };
}

function grouped(parts: readonly Part[]): Part[][] {
  const groups = new Map<string, Part[]>();
  parts.forEach((part, k) => {
    const key = keyOf(part) ?? `alone ${k}`;
    groups.set(key, [...(groups.get(key) ?? []), part]);
  });
  return [...groups.values()];
}

function takenApart(model: Model): Parts {
  model.scene.updateMatrixWorld(true);
  const nodes = new Map(model.nodes.map((node, k) => [node, k]));
  const follows = new Follows(nodes);
  const parts: Part[] = [];
  let [firstWeight, most] = [0, 1];
  model.nodes.forEach((node, k) => {
    for (const body of isBelow(node, model.scene) ? bodiesOf(node, nodes) : []) {
      const { geometry, most: own } = followingGeometry(body, follows.of(body, k));
      most = Math.max(most, own);
      const vertices = geometry.getAttribute("position").count;
      const whole = { primitive: parts.length, firstVertex: 0, vertices, firstCorner: 0 };
      const skinned = body instanceof THREE.SkinnedMesh;
      const collapses = collapsesOf(body.geometry);
      const sources = [{ ...whole, corners: cornersOf(geometry), skinned, collapses }];
      parts.push({ geometry, material: body.material, like: body, firstWeight, sources });
    }
    firstWeight += model.targets[k] ?? 0;
  });
  return { follows: follows.list, parts: grouped(parts).map(merged), primitives: parts.length, most };
}

const known = new WeakMap<Model, Parts>();

/** Returns the parts of a model. */
export function partsOf(model: Model): Parts {
  const parts = known.get(model) ?? takenApart(model);
  known.set(model, parts);
  return parts;
}
