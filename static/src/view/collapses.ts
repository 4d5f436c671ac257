/**
 * The order in which the vertices of a primitive collapse, and the levels of detail of a model, as its extras
 * hold them (docs/detail.md). A model with anything wrong in them is drawn whole.
 */

import * as THREE from "three";
import type { GLTFParser } from "three/examples/jsm/loaders/GLTFLoader.js";

/** All collapses of the steps below `steps` are made; at most `error_m` metres from the full skin. */
export interface DetailLevel {
  steps: number;
  error_m: number;
}

/** The collapses, first to last: `vertices` move onto `onto` at `steps`. */
export interface Collapses {
  vertices: ArrayLike<number>;
  onto: ArrayLike<number>;
  steps: ArrayLike<number>;
}

const NAMES = ["vertices", "onto", "steps"] as const;
const known = new WeakMap<THREE.BufferGeometry, Collapses>();

const isRecord = (value: unknown): value is Record<string, unknown> =>
  typeof value === "object" && value !== null;

/** Returns what an object's extras say under a key. */
function said(extras: unknown, key: string): unknown {
  const own = isRecord(extras) ? extras["statwalk"] : undefined;
  return isRecord(own) ? own[key] : undefined;
}

/** Returns the levels that a model's extras hold, finest first; none if one is wrong. */
export function levelsOf(extras: unknown): DetailLevel[] {
  const values = said(extras, "levels");
  if (!Array.isArray(values)) return [];
  let last = { steps: 0, error_m: 0 };
  const levels: DetailLevel[] = [];
  for (const [steps, error_m] of values.map((value) => (Array.isArray(value) ? (value as unknown[]) : []))) {
    if (typeof steps !== "number" || typeof error_m !== "number") return [];
    if (!Number.isInteger(steps) || steps <= last.steps || !(error_m >= last.error_m)) return [];
    levels.push((last = { steps, error_m }));
  }
  return levels;
}

/** Returns whether collapses fit a primitive with so many vertices: none twice, none onto one that is gone. */
export function fits({ vertices, onto, steps }: Collapses, count: number): boolean {
  if (vertices.length !== onto.length || vertices.length !== steps.length) return false;
  const gone = new Uint8Array(count);
  for (let k = 0; k < vertices.length; k++) {
    const [from, to] = [vertices[k]!, onto[k]!];
    if (from >= count || to >= count || from === to || gone[from] || gone[to]) return false;
    if (k > 0 && steps[k]! < steps[k - 1]!) return false;
    gone[from] = 1;
  }
  return true;
}

async function read(parser: GLTFParser, rows: unknown): Promise<Collapses | null> {
  if (!isRecord(rows)) return null;
  const arrays = await Promise.all(
    NAMES.map(async (name) => {
      const attribute: unknown = await parser.getDependency("accessor", Number(rows[name]));
      return attribute instanceof THREE.BufferAttribute ? attribute.array : [];
    }),
  );
  return { vertices: arrays[0]!, onto: arrays[1]!, steps: arrays[2]! };
}

/** Reads the collapses of a loaded model's meshes; returns its levels, none if it has none or one is wrong. */
export async function readDetail(parser: GLTFParser, scene: THREE.Object3D): Promise<DetailLevel[]> {
  const levels = levelsOf((parser.json as { extras?: unknown }).extras);
  const geometries = new Set<THREE.BufferGeometry>();
  scene.traverse((object) => {
    if (object instanceof THREE.Mesh) geometries.add((object as THREE.Mesh).geometry);
  });
  const found: [THREE.BufferGeometry, Collapses][] = [];
  for (const geometry of levels.length ? geometries : []) {
    const rows = said(geometry.userData, "collapses");
    if (rows === undefined) continue;
    const collapses = await read(parser, rows).catch(() => null);
    if (!collapses || !fits(collapses, geometry.getAttribute("position").count)) return [];
    found.push([geometry, collapses]);
  }
  for (const [geometry, collapses] of found) known.set(geometry, collapses);
  return levels;
}

/** Returns the collapses of a geometry; null: it has none. */
export const collapsesOf = (geometry: THREE.BufferGeometry): Collapses | null => known.get(geometry) ?? null;

/** Returns the vertex that stands for each of `count` vertices after the steps below `steps`. */
export function standsFor(collapses: Collapses, steps: number, count: number): Uint32Array {
  const moved = Uint32Array.from({ length: count }, (_, vertex) => vertex);
  let made = 0;
  while (made < collapses.steps.length && collapses.steps[made]! < steps) made++;
  // Last first: the vertex that a vertex moves onto has already found its own.
  for (let k = made - 1; k >= 0; k--) moved[collapses.vertices[k]!] = moved[collapses.onto[k]!]!;
  return moved;
}
