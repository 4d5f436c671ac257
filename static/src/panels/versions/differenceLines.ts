/** Writes the differences of two versions as lines. */

import type { VersionDifferences } from "../../net/protocol";

export interface DifferenceLine {
  words: string;
  /** null: it is not there. */
  before: string | null;
  after: string | null;
  /** The cell that the line is about. */
  cell: { layer: string; state: string; event: string } | null;
}

const layerWords = (layer: string): string => (layer === "base" ? "" : `${layer}: `);

/** Returns a line for each name, cell and other part that is not the same. */
export function differenceLines({ names, cells, parts }: VersionDifferences): DifferenceLine[] {
  return [
    ...names.map(({ kind, layer, before, after }) => ({
      words: `${layerWords(layer)}${kind}`,
      before,
      after,
      cell: null,
    })),
    ...cells.map(({ layer, state, event, before, after }) => ({
      words: `${layerWords(layer)}${state}, ${event}`,
      before: before ?? "",
      after: after ?? "",
      cell: after === null ? null : { layer, state, event },
    })),
    ...parts.map(({ part, before, after }) => ({ words: part.join(" / "), before, after, cell: null })),
  ];
}
