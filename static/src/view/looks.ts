/** How skin and bones are painted, besides their materials: what the viewer chose. */

import { signal } from "@preact/signals-core";

export const PAINTS = ["materials", "weights", "glue", "normals"] as const;
export const SOLIDS = ["shaded", "wireframe", "textured"] as const;
export type Paint = (typeof PAINTS)[number];
export type Solid = (typeof SOLIDS)[number];

export class Looks {
  /** What the skin shows: its materials, the weights of a bone, its glue, or its normals. */
  readonly paint = signal<Paint>("materials");
  /** The joint whose weights are shown; empty: none. */
  readonly bone = signal<string>("");
  /** How tetrahedra are drawn. */
  readonly solid = signal<Solid>("shaded");
}
