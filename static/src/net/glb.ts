/**
 * Reads GLB messages: the two chunks, and the layout that the JSON describes. The layout stays from frame to
 * frame, so it is read once.
 */

export interface GlbChunks {
  json: Uint8Array;
  bin: Uint8Array;
}

/** A primitive and the places of its arrays in the BIN chunk. */
export interface PrimitiveLayout {
  node: number;
  /** The place of its actor among the actors; -1: it belongs to none. */
  actor: number;
  material: number;
  positions: ArraySlice;
  normals: ArraySlice | null;
  uvs: ArraySlice | null;
  colours: ArraySlice | null;
  indices: ArraySlice | null;
  /** glTF's primitive mode: 4 triangles, 5 strip, 6 fan; lower numbers are lines and points. */
  mode: number;
}

export interface ArraySlice {
  offset: number;
  count: number;
  /** Numbers per element: 1, 2, 3, 4, or 16. */
  size: number;
  componentType: number;
  normalized: boolean;
  /** Bytes from element to element, 0 if the elements are packed. */
  stride: number;
}

export interface GlbLayout {
  primitives: PrimitiveLayout[];
  /** For each actor the world matrices (1+J, 4, 4) of its root and its joints, in column-major order. */
  actors: ArraySlice[];
  nodes: { translation?: number[]; rotation?: number[]; scale?: number[]; name?: string; parent: number }[];
  materialNames: (string | undefined)[];
}

interface GltfJson {
  accessors?: {
    bufferView: number;
    byteOffset?: number;
    count: number;
    type: string;
    componentType: number;
    normalized?: boolean;
  }[];
  bufferViews?: { byteOffset?: number; byteStride?: number }[];
  meshes?: {
    primitives: { attributes: Record<string, number>; indices?: number; material?: number; mode?: number }[];
  }[];
  nodes?: {
    mesh?: number;
    children?: number[];
    translation?: number[];
    rotation?: number[];
    scale?: number[];
    name?: string;
    extras?: { joints?: number };
  }[];
  materials?: { name?: string }[];
}

const JSON_CHUNK = 0x4e4f534a;
const BIN_CHUNK = 0x004e4942;
const SIZES: Record<string, number> = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16 };

export class GlbError extends Error {}

/** Returns the JSON chunk and the BIN chunk as views. */
export function chunksOf(buffer: ArrayBuffer): GlbChunks {
  const view = new DataView(buffer);
  if (buffer.byteLength < 20 || view.getUint32(8, true) !== buffer.byteLength)
    throw new GlbError("GLB is cut short");
  const jsonLength = view.getUint32(12, true);
  const binAt = 20 + jsonLength;
  if (view.getUint32(16, true) !== JSON_CHUNK || binAt + 8 > buffer.byteLength)
    throw new GlbError("GLB has no JSON chunk, or no BIN chunk");
  if (view.getUint32(binAt + 4, true) !== BIN_CHUNK) throw new GlbError("GLB's second chunk is not BIN");
  return {
    json: new Uint8Array(buffer, 20, jsonLength),
    bin: new Uint8Array(buffer, binAt + 8, view.getUint32(binAt, true)),
  };
}

const TICK = /"tick"\s*:\s*"?\s*0*(\d+)/;
const ASSET_BYTES = 1024;

/** Returns the tick in the extras of the asset, which comes first in the JSON, or null. */
export function tickOf(chunks: GlbChunks): number | null {
  const found = TICK.exec(new TextDecoder().decode(chunks.json.subarray(0, ASSET_BYTES)));
  return found ? Number(found[1]) : null;
}

function slice(gltf: GltfJson, accessor: number | undefined): ArraySlice | null {
  const found = accessor === undefined ? undefined : gltf.accessors?.[accessor];
  if (!found) return null;
  const view = gltf.bufferViews?.[found.bufferView];
  const offset = (view?.byteOffset ?? 0) + (found.byteOffset ?? 0);
  const { count, type, componentType, normalized = false } = found;
  return { offset, count, size: SIZES[type] ?? 1, componentType, normalized, stride: view?.byteStride ?? 0 };
}

/** Returns the place among `actorNodes` of the node above `node`, or of itself; -1: there is none. */
function actorOf(nodes: GlbLayout["nodes"], actorNodes: readonly number[], node: number): number {
  for (let at = node; at >= 0; at = nodes[at]!.parent) {
    const actor = actorNodes.indexOf(at);
    if (actor >= 0) return actor;
  }
  return -1;
}

function primitivesOf(gltf: GltfJson, node: number, mesh: number, actor: number): PrimitiveLayout[] {
  return (gltf.meshes?.[mesh]?.primitives ?? []).flatMap(({ attributes, indices, material, mode = 4 }) => {
    const positions = slice(gltf, attributes["POSITION"]);
    if (!positions) return [];
    const [normals, uvs] = [slice(gltf, attributes["NORMAL"]), slice(gltf, attributes["TEXCOORD_0"])];
    const colours = slice(gltf, attributes["COLOR_0"]);
    return [
      {
        node,
        actor,
        material: material ?? -1,
        positions,
        normals,
        uvs,
        colours,
        indices: slice(gltf, indices),
        mode,
      },
    ];
  });
}

/** Reads the layout from the JSON chunk. */
export function layoutOf(chunks: GlbChunks): GlbLayout {
  const gltf = JSON.parse(new TextDecoder().decode(chunks.json)) as GltfJson;
  const nodes: GlbLayout["nodes"] = (gltf.nodes ?? []).map((node) => ({ ...node, parent: -1 }));
  (gltf.nodes ?? []).forEach((node, i) => node.children?.forEach((child) => (nodes[child]!.parent = i)));
  const actorNodes = [...nodes.keys()].filter((node) => slice(gltf, gltf.nodes![node]!.extras?.joints));
  const primitives = (gltf.nodes ?? []).flatMap((node, i) =>
    node.mesh === undefined ? [] : primitivesOf(gltf, i, node.mesh, actorOf(nodes, actorNodes, i)),
  );
  const actors = actorNodes.map((node) => slice(gltf, gltf.nodes![node]!.extras!.joints)!);
  const materialNames = (gltf.materials ?? []).map((material) => material.name);
  return { primitives, actors, nodes, materialNames };
}

const ARRAYS = {
  5120: Int8Array,
  5121: Uint8Array,
  5122: Int16Array,
  5123: Uint16Array,
  5125: Uint32Array,
  5126: Float32Array,
} as const;

export type GlArray = Int8Array | Uint8Array | Int16Array | Uint16Array | Uint32Array | Float32Array;

/**
 * Returns an array of the BIN chunk: a view if it is packed, else a copy. Throws GlbError on a component type
 * that is not glTF's.
 */
export function view(bin: Uint8Array, { offset, count, size, componentType, stride }: ArraySlice): GlArray {
  if (!(componentType in ARRAYS)) throw new GlbError(`component type ${componentType} is not one of glTF's`);
  const Kind = ARRAYS[componentType as keyof typeof ARRAYS];
  const element = size * Kind.BYTES_PER_ELEMENT;
  if (!stride || stride === element)
    return new Kind(bin.buffer as ArrayBuffer, bin.byteOffset + offset, count * size);
  const bytes = new Uint8Array(count * element);
  for (let i = 0; i < count; i++)
    bytes.set(bin.subarray(offset + i * stride, offset + i * stride + element), i * element);
  return new Kind(bytes.buffer);
}
