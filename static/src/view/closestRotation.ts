/**
 * The rotation closest to a matrix: a bone's turn without its stretch. The same numbers as the server's
 * (`skin/closest_rotation.py`, where the way is explained).
 */

const MOST_SQUARINGS = 24;
const ENOUGH = 1 - 1e-6;
const FLAT = 1e-6;

type Four = [number, number, number, number];

/** The symmetric 4 × 4 matrix of a bone: its upper right, row by row. One array serves all bones of a frame. */
const m = new Float64Array(10);

function trace(): number {
  return m[0]! + m[4]! + m[7]! + m[9]!;
}

/** Squares the matrix, divided by `size`. */
function square(size: number): void {
  for (let k = 0; k < 10; k++) m[k]! /= size;
  const [a, b, c, d, e] = [m[0]!, m[1]!, m[2]!, m[3]!, m[4]!];
  const [f, g, h, i, j] = [m[5]!, m[6]!, m[7]!, m[8]!, m[9]!];
  m[0] = a * a + b * b + c * c + d * d;
  m[1] = a * b + b * e + c * f + d * g;
  m[2] = a * c + b * f + c * h + d * i;
  m[3] = a * d + b * g + c * i + d * j;
  m[4] = b * b + e * e + f * f + g * g;
  m[5] = b * c + e * f + f * h + g * i;
  m[6] = b * d + e * g + f * i + g * j;
  m[7] = c * c + f * f + h * h + i * i;
  m[8] = c * d + f * g + h * i + i * j;
  m[9] = d * d + g * g + i * i + j * j;
}

/** Where the numbers of a column are. */
const COLUMNS = [
  [0, 1, 2, 3],
  [1, 4, 5, 6],
  [2, 5, 7, 8],
  [3, 6, 8, 9],
] as const;

/** Returns the column with the largest diagonal at unit length. */
function longest(): Four {
  let column = 3;
  for (let k = 0; k < 3; k++) if (m[COLUMNS[k]![k]!]! > m[COLUMNS[column]![column]!]!) column = k;
  const [x, y, z, w] = COLUMNS[column]!;
  const length = Math.hypot(m[x]!, m[y]!, m[z]!, m[w]!);
  return [m[x]! / length, m[y]! / length, m[z]! / length, m[w]! / length];
}

/**
 * Returns the unit quaternion x y z w closest to the upper left 3 x 3 of a matrix of sixteen numbers, column
 * by column; for a mirror closest to the negative matrix; for zeros and NaN the identity.
 */
export function closestRotation(matrix: ArrayLike<number>, at = 0): Four {
  let [a, d, g] = [matrix[at]!, matrix[at + 1]!, matrix[at + 2]!];
  let [b, e, h] = [matrix[at + 4]!, matrix[at + 5]!, matrix[at + 6]!];
  let [c, f, i] = [matrix[at + 8]!, matrix[at + 9]!, matrix[at + 10]!];
  const size = Math.sqrt((a * a + b * b + c * c + d * d + e * e + f * f + g * g + h * h + i * i) / 3);
  if (a * (e * i - f * h) + b * (f * g - d * i) + c * (d * h - e * g) < -FLAT * size ** 3)
    [a, b, c, d, e, f, g, h, i] = [-a, -b, -c, -d, -e, -f, -g, -h, -i];
  if (!(size > 0 && size < Infinity)) return [0, 0, 0, 1];
  [m[0], m[1], m[2], m[3]] = [size + a - e - i, b + d, c + g, h - f];
  [m[4], m[5], m[6]] = [size - a + e - i, f + h, c - g];
  [m[7], m[8], m[9]] = [size - a - e + i, d - b, size + a + e + i];
  for (let step = 0, total = 4 * size; step < MOST_SQUARINGS; step++) {
    square(total);
    total = trace();
    if (step && total > ENOUGH) break;
  }
  return longest();
}
