/** Places the joints of all actors of a cast: world matrices in one array, without an object for each joint. */

import type { CastFrame } from "../net/wire";

const ROOT_SIZE = 7;
type Numbers = ArrayLike<number>;

/**
 * Writes the matrix T · R · S into 16 numbers of `out` from `at`, column by column. Read from `t` numbers into
 * `translation`, `r` into `rotation` (x y z w), and `s` into `scale`; null: 1.
 */
function compose(
  out: Float64Array,
  at: number,
  translation: Numbers,
  t: number,
  rotation: Numbers,
  r: number,
  scale: Numbers | null,
  s: number,
): void {
  const x = rotation[r]!;
  const y = rotation[r + 1]!;
  const z = rotation[r + 2]!;
  const w = rotation[r + 3]!;
  const sx = scale ? scale[s]! : 1;
  const sy = scale ? scale[s + 1]! : 1;
  const sz = scale ? scale[s + 2]! : 1;
  out[at] = (1 - 2 * (y * y + z * z)) * sx;
  out[at + 1] = 2 * (x * y + w * z) * sx;
  out[at + 2] = 2 * (x * z - w * y) * sx;
  out[at + 4] = 2 * (x * y - w * z) * sy;
  out[at + 5] = (1 - 2 * (x * x + z * z)) * sy;
  out[at + 6] = 2 * (y * z + w * x) * sy;
  out[at + 8] = 2 * (x * z + w * y) * sz;
  out[at + 9] = 2 * (y * z - w * x) * sz;
  out[at + 10] = (1 - 2 * (x * x + y * y)) * sz;
  out[at + 12] = translation[t]!;
  out[at + 13] = translation[t + 1]!;
  out[at + 14] = translation[t + 2]!;
  out[at + 15] = 1;
}

/**
 * Writes the product of two matrices of points (last row 0 0 0 1) into 16 numbers of `out` from `at`: `left`
 * from `l` and `right` from `r`, column by column. `out` may be `right` at the same place.
 */
export function multiplyInto(
  out: Float64Array | Float32Array,
  at: number,
  left: Numbers,
  l: number,
  right: Numbers,
  r: number,
): void {
  for (let column = 0; column < 16; column += 4) {
    const x = right[r + column]!;
    const y = right[r + column + 1]!;
    const z = right[r + column + 2]!;
    const w = column === 12 ? 1 : 0;
    out[at + column] = left[l]! * x + left[l + 4]! * y + left[l + 8]! * z + left[l + 12]! * w;
    out[at + column + 1] = left[l + 1]! * x + left[l + 5]! * y + left[l + 9]! * z + left[l + 13]! * w;
    out[at + column + 2] = left[l + 2]! * x + left[l + 6]! * y + left[l + 10]! * z + left[l + 14]! * w;
    out[at + column + 3] = w;
  }
}

export class CastPose {
  /** (N, 1 + J, 16) the world matrices of each actor's root and joints, metres, column by column. */
  readonly matrices: Float64Array;
  /** The frame that the matrices come from; null: the server gave the matrices. */
  frame: CastFrame | null = null;

  constructor(
    readonly actors: number,
    /** Of each joint its parent, which comes before it; -1: the root. */
    readonly parents: readonly number[],
  ) {
    this.matrices = new Float64Array(actors * this.stride);
    for (let at = 0; at < this.matrices.length; at += 16) this.matrices.set(IDENTITY, at);
  }

  get joints(): number {
    return this.parents.length;
  }

  /** Numbers for each actor. */
  private get stride(): number {
    return 16 * (1 + this.joints);
  }

  /** The first number of the matrix of a joint; joint -1: of the root. */
  indexOf(row: number, joint: number): number {
    return row * this.stride + 16 * (1 + joint);
  }

  /** The world matrix (16) of a joint; joint -1: of the root. */
  world(row: number, joint: number): Float64Array {
    const at = this.indexOf(row, joint);
    return this.matrices.subarray(at, at + 16);
  }

  /** Takes the poses of a frame of the pose stream. */
  take(frame: CastFrame): void {
    this.frame = frame;
    for (let row = 0; row < this.actors; row++) this.takeRow(frame, row);
  }

  private takeRow({ root, translation, rotation, scale }: CastFrame, row: number): void {
    const { matrices, joints, parents } = this;
    const first = row * this.stride;
    compose(matrices, first, root, row * ROOT_SIZE, root, row * ROOT_SIZE + 3, null, 0);
    for (let joint = 0; joint < joints; joint++) {
      const at = first + 16 * (1 + joint);
      const element = row * joints + joint;
      compose(matrices, at, translation, 3 * element, rotation, 4 * element, scale, 3 * element);
      multiplyInto(matrices, at, matrices, first + 16 * (1 + parents[joint]!), matrices, at);
    }
  }

  /** Takes an actor's world matrices (1 + J, 16) from the server; matrices of other actors are refused. */
  place(row: number, matrices: Float32Array | undefined): void {
    if (matrices?.length !== this.stride || row >= this.actors) return;
    this.frame = null;
    this.matrices.set(matrices, row * this.stride);
  }
}

const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
