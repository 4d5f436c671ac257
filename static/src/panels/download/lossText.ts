/** Says in one line what a file format cannot hold of a character. */

/** A kind of part that a format cannot hold, and what the file has in its place. */
interface Loss {
  part: string;
  count: number;
  instead: string;
}

/** Returns `cannot hold skins (2), meshes (1)`; what has a substitute comes after a semicolon. */
export function lossText(lost: readonly Loss[]): string {
  if (!lost.length) return "holds everything";
  const gone = lost.filter(({ instead }) => !instead).map(({ part, count }) => `${part} (${count})`);
  const changed = lost.filter(({ instead }) => instead).map(({ part, instead }) => `${part}: ${instead}`);
  const sentences = [gone.length ? `cannot hold ${gone.join(", ")}` : "", changed.join(", ")];
  return sentences.filter(Boolean).join("; ");
}
