/**
 * One level of detail of a crowd: a body for each part, and which actors it draws. The actors stand in the
 * order of their distance: the nearest first, so that those behind are hidden at once; where a material is
 * blended, the farthest first.
 */

import * as THREE from "three";
import type { Skinning } from "../net/protocol";
import { type Body, materialsOf } from "./bodies";
import { CrowdGeometry, Roster, bodyOf } from "./crowdMesh";
import type { Part } from "./crowdParts";
import { dropNormals } from "./normals";
import type { PoseTexture } from "./poseTexture";
import { geometryIn } from "./skinWays";

/** Returns the triangles of a part at a level, three vertices each; null: all. */
export type Detail = (part: Part) => THREE.BufferAttribute | null;

export class CrowdLevel {
  /** One for each part. */
  readonly bodies: readonly Body[];
  private readonly nearFirst: Roster;
  private readonly farFirst: Roster;

  constructor(
    private readonly parts: readonly Part[],
    ids: readonly number[],
    pose: PoseTexture,
    private readonly detail: Detail,
  ) {
    this.nearFirst = new Roster(ids, pose);
    this.farFirst = new Roster(ids, pose);
    this.bodies = parts.map((part) => bodyOf(part, this.geometryOf(part, "linear"), pose));
  }

  private geometryOf(part: Part, way: Skinning): CrowdGeometry {
    const { geometry, like } = part;
    const isBlended = materialsOf(like).some(({ transparent }) => transparent);
    const shaped = geometryIn(geometry, way, like instanceof THREE.Mesh);
    // Pieces have corners of their own: the levels do not know them.
    const index = way === "parts" ? shaped.index : (this.detail(part) ?? shaped.index);
    return new CrowdGeometry(isBlended ? this.farFirst : this.nearFirst).share(shaped, index);
  }

  /** Skins in a way. */
  skin(way: Skinning): void {
    this.parts.forEach((part, k) => {
      const body = this.bodies[k]!;
      this.free(body);
      body.geometry = this.geometryOf(part, way);
    });
  }

  /** Draws the actors of these rows of the cast, nearest first. */
  take(rows: readonly number[]): void {
    this.nearFirst.take(rows);
    this.farFirst.take([...rows].reverse());
  }

  private free(body: Body): void {
    if (body instanceof THREE.Mesh) dropNormals(body);
    body.geometry.dispose();
  }

  dispose(): void {
    for (const body of this.bodies) this.free(body);
  }
}
