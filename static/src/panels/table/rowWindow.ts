/** Says which lines of a long table are drawn: those in sight, those beside them, and a few that stay. */

/** Up to so many lines all are drawn. */
const MOST_LINES = 60;
/** Lines that are drawn above and below those in sight. */
const BESIDE = 10;

/** What is seen of a table: pixels, and the height of a line. */
export interface Sight {
  top: number;
  height: number;
  line: number;
}

/** Returns the lines to draw of `count`, in order; `stay`: lines that are drawn also out of sight. */
export function drawnLines(count: number, { top, height, line }: Sight, stay: Iterable<number>): number[] {
  const all = Array.from({ length: count }, (_, i) => i);
  if (count <= MOST_LINES) return all;
  const first = Math.floor(top / line) - BESIDE;
  const last = Math.ceil((top + height) / line) + BESIDE;
  const staying = new Set(stay);
  return all.filter((i) => (i >= first && i <= last) || staying.has(i));
}

/** Returns how many lines are left out before each drawn line, and after the last. */
export function gaps(count: number, drawn: readonly number[]): number[] {
  const before = drawn.map((line, i) => line - (drawn[i - 1] ?? -1) - 1);
  return [...before, count - 1 - (drawn.at(-1) ?? -1)];
}
