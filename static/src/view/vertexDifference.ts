/** Compares the vertices of a part, as the GPU poses them, with the server's vertices. */

import * as THREE from "three";
import type { Skinning } from "../net/protocol";
import type { Part, Source } from "./crowdParts";

/** A primitive of the server: its vertices (V, 3) in the stage, metres, and its triangles. */
export interface ServerPrimitive {
  places: Float64Array;
  order: ArrayLike<number> | null;
}

/** Calls `pair` with the vertex of the page and the vertex of the server that are the same. */
function eachPair(
  { geometry, like }: Part,
  { firstVertex, vertices, firstCorner, corners, skinned }: Source,
  { places, order }: ServerPrimitive,
  way: Skinning,
  pair: (page: number, server: number) => void,
): void {
  const count = places.length / 3;
  if (way !== "parts" || !(like instanceof THREE.Mesh)) {
    if (count !== vertices) throw new Error(`the server has ${count} vertices, the page ${vertices}`);
    for (let vertex = 0; vertex < vertices; vertex++) pair(firstVertex + vertex, vertex);
    return;
  }
  // The page has torn all triangles apart, the server only triangles of skins; corners keep their order.
  if (skinned && order?.length !== corners)
    throw new Error(`the server has ${order?.length ?? 0} corners of triangles, the page ${corners}`);
  for (let corner = firstCorner; corner < firstCorner + corners; corner++)
    pair(
      corner,
      skinned ? order![corner - firstCorner]! : (geometry.index?.getX(corner) ?? corner) - firstVertex,
    );
}

/** Returns the largest distance, metres; `gpu` (V, 4) are the vertices of the part. */
export function largestDifference(
  part: Part,
  gpu: Float32Array,
  primitives: readonly ServerPrimitive[],
  way: Skinning,
): number {
  let most = 0;
  for (const source of part.sources) {
    const primitive = primitives[source.primitive];
    if (!primitive) throw new Error("the server has fewer primitives");
    eachPair(part, source, primitive, way, (page, server) => {
      const [p, s] = [4 * page, 3 * server];
      const { places } = primitive;
      const away = Math.hypot(
        gpu[p]! - places[s]!,
        gpu[p + 1]! - places[s + 1]!,
        gpu[p + 2]! - places[s + 2]!,
      );
      most = Math.max(most, away); // of NaN it is NaN
    });
  }
  return most;
}
