/** The glb stream: each message is a complete GLB that the server has skinned; after the first, only positions and normals are taken. */

import * as THREE from "three";
import { toTrianglesDrawMode } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import { type ArraySlice, type GlbChunks, type GlbLayout, type PrimitiveLayout, layoutOf, view } from "../net/glb";

const TRIANGLES = 4;
/** One vertex in so many tells where the skin is. */
const SAMPLED = 13;

/** The material for a primitive of the stream, from the model that was loaded with its textures. */
export type MaterialChooser = (index: number, name: string | undefined) => THREE.Material | undefined;

function attribute(bin: Uint8Array, slice: ArraySlice): THREE.BufferAttribute {
  return new THREE.BufferAttribute(view(bin, slice).slice(), slice.size, slice.normalized);
}

function geometryOf(bin: Uint8Array, layout: PrimitiveLayout): THREE.BufferGeometry {
  const geometry = new THREE.BufferGeometry();
  const named = { position: layout.positions, normal: layout.normals, uv: layout.uvs, color: layout.colours };
  for (const [name, slice] of Object.entries(named)) if (slice) geometry.setAttribute(name, attribute(bin, slice));
  if (layout.indices) geometry.setIndex(attribute(bin, layout.indices));
  return layout.mode > TRIANGLES ? toTrianglesDrawMode(geometry, layout.mode === 5 ? THREE.TriangleStripDrawMode : THREE.TriangleFanDrawMode) : geometry;
}

/** The material as this primitive needs it: flat without normals, coloured by vertex where it has colours. */
function fitted(material: THREE.Material, { normals, colours }: PrimitiveLayout): THREE.Material {
  const flatShading = normals === null;
  const vertexColors = colours !== null;
  const own = material as THREE.MeshStandardMaterial;
  if ((own.flatShading ?? flatShading) === flatShading && own.vertexColors === vertexColors) return material;
  return Object.assign(material.clone(), { flatShading, vertexColors });
}

function worldOf(layout: GlbLayout, node: number): THREE.Matrix4 {
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
  readonly meshes: THREE.Mesh[] = [];
  private layout: GlbLayout | null = null;
  private shape = "";
  private readonly plain = new THREE.MeshStandardMaterial({ color: 0xb9bcc4, roughness: 0.8 });

  constructor(
    private readonly shadows: boolean,
    private readonly material: MaterialChooser,
  ) {}

  /** Shows a frame; says whether its layout was a new one, so that the meshes are others than before. */
  apply(chunks: GlbChunks): boolean {
    const shape = `${chunks.json.length}/${chunks.bin.length}`;
    const fresh = shape !== this.shape;
    if (fresh) this.build(chunks, shape);
    else this.rewrite(chunks.bin);
    return fresh;
  }

  private build(chunks: GlbChunks, shape: string): void {
    this.clear();
    this.layout = layoutOf(chunks);
    this.shape = shape;
    this.layout.primitives = this.layout.primitives.filter(({ mode }) => mode >= TRIANGLES);
    for (const primitive of this.layout.primitives) {
      const name = this.layout.materialNames[primitive.material];
      const material = fitted(this.material(primitive.material, name) ?? this.plain, primitive);
      const mesh = new THREE.Mesh(geometryOf(chunks.bin, primitive), material);
      mesh.applyMatrix4(worldOf(this.layout, primitive.node));
      Object.assign(mesh, { frustumCulled: false, castShadow: this.shadows, receiveShadow: this.shadows });
      this.meshes.push(mesh);
      this.root.add(mesh);
    }
  }

  private rewrite(bin: Uint8Array): void {
    this.layout!.primitives.forEach((primitive, i) => {
      const { position, normal } = this.meshes[i]!.geometry.attributes;
      this.copy(bin, primitive.positions, position as THREE.BufferAttribute);
      if (primitive.normals) this.copy(bin, primitive.normals, normal as THREE.BufferAttribute);
    });
  }

  private copy(bin: Uint8Array, slice: ArraySlice, into: THREE.BufferAttribute): void {
    (into.array as Float32Array).set(view(bin, slice));
    into.needsUpdate = true;
  }

  /** Where the skin stands on the ground: the middle of some of its vertices; null before the first frame. */
  centre(): THREE.Vector3 | null {
    const sum = new THREE.Vector3();
    const vertex = new THREE.Vector3();
    let count = 0;
    for (const mesh of this.meshes) {
      const positions = mesh.geometry.getAttribute("position") as THREE.BufferAttribute;
      for (let i = 0; i < positions.count; i += SAMPLED) {
        sum.add(vertex.fromBufferAttribute(positions, i).applyMatrix4(mesh.matrix));
        count++;
      }
    }
    return count ? sum.divideScalar(count).setY(0) : null;
  }

  /** Forgets the layout: the actors changed, or the stage. */
  clear(): void {
    for (const mesh of this.meshes) mesh.geometry.dispose();
    this.root.clear();
    this.meshes.length = 0;
    this.shape = "";
  }
}
