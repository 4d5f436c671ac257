/**
 * Draws the glb stream: each message is a complete, skinned GLB; after the first one only positions and
 * normals are read, and the matrices of roots and joints.
 */

import * as THREE from "three";
import { toTrianglesDrawMode } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import {
  type ArraySlice,
  type GlbChunks,
  type GlbLayout,
  type PrimitiveLayout,
  layoutOf,
  view,
} from "../net/glb";
import { NOBODY } from "./actorPick";
import { type Body, stroke } from "./bodies";
import { dropNormals, refreshNormals } from "./normals";

const TRIANGLES = 4;

/** Finds the material of a primitive in the loaded model, which has the textures. */
export type MaterialLookup = (index: number, name: string | undefined) => THREE.Material | undefined;

function attribute(bin: Uint8Array, slice: ArraySlice): THREE.BufferAttribute {
  return new THREE.BufferAttribute(view(bin, slice).slice(), slice.size, slice.normalized);
}

function geometryOf(bin: Uint8Array, layout: PrimitiveLayout): THREE.BufferGeometry {
  const geometry = new THREE.BufferGeometry();
  const named = { position: layout.positions, normal: layout.normals, uv: layout.uvs, color: layout.colours };
  for (const [name, slice] of Object.entries(named))
    if (slice) geometry.setAttribute(name, attribute(bin, slice));
  if (layout.indices) geometry.setIndex(attribute(bin, layout.indices));
  return layout.mode > TRIANGLES
    ? toTrianglesDrawMode(
        geometry,
        layout.mode === 5 ? THREE.TriangleStripDrawMode : THREE.TriangleFanDrawMode,
      )
    : geometry;
}

/** One id for all vertices: they are drawn as the first, and only, instance. */
const idOf = (actor: number): THREE.InstancedBufferAttribute =>
  new THREE.InstancedBufferAttribute(new Float32Array([actor]), 1);

/** Fits a material to a primitive: flat if it has no normals, coloured by vertex if it has colours. */
function fitted(material: THREE.Material, { normals, colours }: PrimitiveLayout): THREE.Material {
  const flatShading = normals === null;
  const vertexColors = colours !== null;
  const own: THREE.Material & { flatShading?: boolean } = material;
  if ((own.flatShading ?? flatShading) === flatShading && own.vertexColors === vertexColors) return material;
  return Object.assign(material.clone(), { flatShading, vertexColors });
}

/** Returns the world matrix of a node. */
export function worldOf(layout: GlbLayout, node: number): THREE.Matrix4 {
  const world = new THREE.Matrix4();
  for (let at = node; at >= 0; at = layout.nodes[at]!.parent) {
    const { translation, rotation, scale } = layout.nodes[at]!;
    const [t, r, s] = [new THREE.Vector3(), new THREE.Quaternion(), new THREE.Vector3(1, 1, 1)];
    if (translation) t.fromArray(translation);
    if (rotation) r.fromArray(rotation);
    if (scale) s.fromArray(scale);
    world.premultiply(new THREE.Matrix4().compose(t, r, s));
  }
  return world;
}

export class GlbStage {
  readonly root = new THREE.Group();
  readonly meshes: Body[] = [];
  /** Of each actor of the shown frame the world matrices of its root and its joints, column by column. */
  actors: Float32Array[] = [];
  private layout: GlbLayout | null = null;
  private shape = "";
  /** glTF's default material. */
  private readonly plain = new THREE.MeshStandardMaterial({ color: 0xffffff, metalness: 1, roughness: 1 });

  constructor(
    private readonly shadows: boolean,
    private readonly material: MaterialLookup,
  ) {}

  /** Shows a frame of the actors `ids`; returns whether it has a new layout, and so new meshes. */
  apply(chunks: GlbChunks, ids: readonly number[]): boolean {
    const shape = `${chunks.json.length}/${chunks.bin.length}`;
    const fresh = shape !== this.shape;
    if (fresh) this.build(chunks, shape, ids);
    else this.rewrite(chunks.bin);
    this.actors = this.layout!.actors.map((slice) => view(chunks.bin, slice) as Float32Array);
    return fresh;
  }

  private build(chunks: GlbChunks, shape: string, ids: readonly number[]): void {
    this.clear();
    this.layout = layoutOf(chunks);
    this.shape = shape;
    for (const primitive of this.layout.primitives) {
      const name = this.layout.materialNames[primitive.material];
      const mesh = this.bodyOf(chunks.bin, primitive, this.material(primitive.material, name));
      mesh.geometry.setAttribute("actorId", idOf(ids[primitive.actor] ?? NOBODY));
      mesh.applyMatrix4(worldOf(this.layout, primitive.node));
      Object.assign(mesh, { frustumCulled: false, castShadow: this.shadows, receiveShadow: this.shadows });
      this.meshes.push(mesh);
      this.root.add(mesh);
    }
  }

  private bodyOf(bin: Uint8Array, primitive: PrimitiveLayout, material: THREE.Material | undefined): Body {
    const geometry = geometryOf(bin, primitive);
    return primitive.mode < TRIANGLES
      ? stroke(geometry, primitive.mode, material)
      : new THREE.Mesh(geometry, fitted(material ?? this.plain, primitive));
  }

  private rewrite(bin: Uint8Array): void {
    this.layout!.primitives.forEach((primitive, i) => {
      const { position, normal } = this.meshes[i]!.geometry.attributes;
      this.copy(bin, primitive.positions, position as THREE.BufferAttribute);
      if (primitive.normals) this.copy(bin, primitive.normals, normal as THREE.BufferAttribute);
      if (this.meshes[i] instanceof THREE.Mesh) refreshNormals(this.meshes[i]);
    });
  }

  private copy(bin: Uint8Array, slice: ArraySlice, into: THREE.BufferAttribute): void {
    (into.array as Float32Array).set(view(bin, slice));
    into.needsUpdate = true;
  }

  /** Removes the meshes and the layout. */
  clear(): void {
    for (const mesh of this.meshes) mesh.geometry.dispose();
    for (const mesh of this.meshes) if (mesh instanceof THREE.Mesh) dropNormals(mesh);
    this.root.clear();
    this.meshes.length = 0;
    this.actors = [];
    this.shape = "";
  }
}
