/** Moves from cell to cell by the arrow keys. */

export interface Spot {
  row: number;
  column: number;
}

/** Rows. */
const PAGE = 10;
const STEPS: Record<string, [number, number]> = {
  ArrowUp: [-1, 0],
  ArrowDown: [1, 0],
  ArrowLeft: [0, -1],
  ArrowRight: [0, 1],
  PageUp: [-PAGE, 0],
  PageDown: [PAGE, 0],
};

/** Returns the cell that `key` leads to, or null if the key does not move. */
export function moved(from: Spot, key: string, rows: number, columns: number): Spot | null {
  const within = (value: number, size: number): number => Math.min(size - 1, Math.max(0, value));
  if (key === "Home") return { row: from.row, column: 0 };
  if (key === "End") return { row: from.row, column: columns - 1 };
  const step = STEPS[key];
  return step
    ? { row: within(from.row + step[0], rows), column: within(from.column + step[1], columns) }
    : null;
}

/** Returns the first start from `least` on, or `least`. */
export function firstFrom(starts: readonly number[], least: number): number {
  return starts.find((start) => start >= least) ?? least;
}
