/** The triangles of a level of detail, over the vertices of the full skin: only the index is another. */

import * as THREE from "three";
import { type Collapses, standsFor } from "./collapses";

/** A primitive in a geometry: where its vertices and its triangles' corners are. */
export interface IndexedPiece {
  firstVertex: number;
  vertices: number;
  firstCorner: number;
  corners: number;
  /** Null: it stays whole. */
  collapses: Collapses | null;
}

const places = new WeakMap<THREE.BufferGeometry, Uint32Array>();

/** Returns a number for the place of each vertex. */
function placesOf(geometry: THREE.BufferGeometry): Uint32Array {
  const found = places.get(geometry);
  if (found) return found;
  const position = geometry.getAttribute("position");
  const numbers = new Map<string, number>();
  const made = Uint32Array.from({ length: position.count }, (_, vertex) => {
    const key = `${position.getX(vertex)} ${position.getY(vertex)} ${position.getZ(vertex)}`;
    if (!numbers.has(key)) numbers.set(key, numbers.size);
    return numbers.get(key)!;
  });
  places.set(geometry, made);
  return made;
}

/** Returns the corners of the triangles with area that a piece has left after the steps below `steps`. */
function cornersLeft(geometry: THREE.BufferGeometry, piece: IndexedPiece, steps: number): number[] {
  const { firstVertex, vertices, firstCorner, corners, collapses } = piece;
  const [index, place] = [geometry.index, placesOf(geometry)];
  const moved = collapses && standsFor(collapses, steps, vertices);
  const left: number[] = [];
  const cornerAt = (at: number): number => {
    const vertex = index?.getX(firstCorner + at) ?? firstCorner + at;
    return moved ? firstVertex + moved[vertex - firstVertex]! : vertex;
  };
  for (let at = 0; at + 2 < corners; at += 3) {
    const [a, b, c] = [cornerAt(at), cornerAt(at + 1), cornerAt(at + 2)];
    const [p, q, r] = [place[a], place[b], place[c]];
    if (!moved || (p !== q && q !== r && r !== p)) left.push(a, b, c);
  }
  return left;
}

/** Returns the index of a geometry of triangles after the steps below `steps`; null if nothing collapses. */
export function levelIndex(
  geometry: THREE.BufferGeometry,
  pieces: readonly IndexedPiece[],
  steps: number,
): THREE.BufferAttribute | null {
  if (pieces.every(({ collapses }) => !collapses)) return null;
  const corners = pieces.flatMap((piece) => cornersLeft(geometry, piece, steps));
  const wide = geometry.getAttribute("position").count > 0xffff;
  return new THREE.BufferAttribute(wide ? new Uint32Array(corners) : new Uint16Array(corners), 1);
}
