/** Draws the uneven ground of a machine: steps and slopes as blocks on the floor. */

import * as THREE from "three";
import type { GroundPiece } from "../net/protocol";
import { fade } from "./cutaway";

/** Faces of a block whose corners are numbered round its top (0 to 3) and round its foot (4 to 7). */
const FACES = [
  [0, 3, 2, 1],
  [0, 1, 5, 4],
  [1, 2, 6, 5],
  [2, 3, 7, 6],
  [3, 0, 4, 7],
];

/** Returns the triangles of a block, three corners of three numbers each, counter-clockwise from outside. */
export function blockTriangles({ corner, opposite, heights }: GroundPiece): number[] {
  const [x0 = 0, z0 = 0] = corner;
  const [x1 = 0, z1 = 0] = opposite;
  const around = [
    [x0, z0],
    [x1, z0],
    [x1, z1],
    [x0, z1],
  ];
  const top = around.map(([x, z], k) => [x!, heights[k]!, z!]);
  const corners = [...top, ...around.map(([x, z]) => [x!, 0, z!])];
  return FACES.flatMap(([a, b, c, d]) => [a, b, c, a, c, d].flatMap((k) => corners[k!]!));
}

/** Returns the edges of a block, two corners of three numbers each; those on the floor are left out. */
export function blockEdges(piece: GroundPiece): number[] {
  const triangles = blockTriangles(piece);
  const corner = (k: number): number[] => triangles.slice(3 * k, 3 * k + 3);
  const top = [corner(0), corner(1), corner(2), corner(5)];
  const around = top.flatMap((from, k) => [...from, ...top[(k + 1) % 4]!]);
  return [...around, ...top.flatMap(([x, y, z]) => [x!, y!, z!, x!, 0, z!])];
}

export class Terrain {
  readonly mesh = new THREE.Mesh(
    new THREE.BufferGeometry(),
    new THREE.MeshStandardMaterial({
      color: 0x8a8f98,
      roughness: 0.95,
      flatShading: true,
      polygonOffset: true,
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 1,
    }),
  );
  private readonly edges = new THREE.LineSegments(
    new THREE.BufferGeometry(),
    new THREE.LineBasicMaterial({ color: 0x30343a, transparent: true, opacity: 0.55 }),
  );

  constructor() {
    fade([this.mesh], true);
    this.mesh.receiveShadow = true;
    this.mesh.castShadow = true;
    this.mesh.visible = false;
    this.mesh.add(this.edges);
  }

  /** Shows the ground of a machine; none for an empty list. */
  show(pieces: GroundPiece[]): void {
    this.mesh.geometry.dispose();
    const positions = new THREE.Float32BufferAttribute(pieces.flatMap(blockTriangles), 3);
    this.mesh.geometry = new THREE.BufferGeometry().setAttribute("position", positions);
    this.mesh.geometry.computeVertexNormals();
    const edges = new THREE.Float32BufferAttribute(pieces.flatMap(blockEdges), 3);
    this.edges.geometry.dispose();
    this.edges.geometry = new THREE.BufferGeometry().setAttribute("position", edges);
    this.mesh.visible = pieces.length > 0;
  }
}
