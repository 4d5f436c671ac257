/** Reads the texts of the fields of markers; throws errors with words for the user. */

/** Reads a phase of a marker; blank takes the marker away. */
export function phase(text: string): number | null {
  if (!text.trim()) return null;
  const value = Number(text);
  if (!(value >= 0 && value <= 1)) throw new Error("a phase from 0 to 1; blank: no marker");
  return value;
}

/** Reads a name and a phase. */
export function newMarker(text: string): { name: string; at: number | null } {
  const [, name, at] = /^\s*(\S+)\s+([\d.]+)\s*$/.exec(text) ?? [];
  if (!name || !at) throw new Error("a name and a phase, as in: left-down 0.25");
  return { name, at: phase(at) };
}
