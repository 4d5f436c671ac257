/** Reads a binary message of the pose stream as typed views, without a copy. */

const MAGIC = 0x31575453; // "STW1"
const HEADER_BYTES = 32;
const CAST_HEADER_BYTES = 16;
const ROOT_SIZE = 7;

/** One cast of a frame; every array is a view into the message, actor by actor. */
export interface CastFrame {
  actors: number;
  joints: number;
  weightCount: number;
  layers: number;
  /** (n, J, 3) metres, local. */
  translation: Float32Array;
  /** (n, J, 4) x y z w, local. */
  rotation: Float32Array;
  /** (n, J, 3), local. */
  scale: Float32Array;
  /** (n, W) morph weights. */
  weights: Float32Array;
  /** (n, 7) x y z and quaternion x y z w of the actor in the stage. */
  root: Float32Array;
  /** (n, L) phase of the state's motion, 0…1. */
  phase: Float32Array;
  /** (n, L) share of the transition that remains, 1…0. */
  blend: Float32Array;
  /** (n, L) index of the state. */
  state: Uint32Array;
}

export interface PoseFrame {
  epoch: number;
  tick: number;
  head: number;
  /** The stage's 64-bit hash as 16 hex digits. */
  hash: string;
  bytes: number;
  casts: CastFrame[];
}

export class WireError extends Error {}

interface Cursor {
  buffer: ArrayBuffer;
  at: number;
}

function floats(cursor: Cursor, count: number): Float32Array {
  const view = new Float32Array(cursor.buffer, cursor.at, count);
  cursor.at += count * 4;
  return view;
}

function castBytes(n: number, joints: number, weights: number, layers: number): number {
  return 4 * n * (joints * 10 + weights + ROOT_SIZE + layers * 3);
}

function readCast(cursor: Cursor): CastFrame {
  if (cursor.at + CAST_HEADER_BYTES > cursor.buffer.byteLength)
    throw new WireError("frame ends inside a cast header");
  const header = new Uint32Array(cursor.buffer, cursor.at, 4);
  const [n, joints, weightCount, layers] = header as unknown as [number, number, number, number];
  cursor.at += CAST_HEADER_BYTES;
  if (cursor.at + castBytes(n, joints, weightCount, layers) > cursor.buffer.byteLength)
    throw new WireError("frame ends inside a cast");
  const frame: CastFrame = {
    actors: n,
    joints,
    weightCount,
    layers,
    translation: floats(cursor, n * joints * 3),
    rotation: floats(cursor, n * joints * 4),
    scale: floats(cursor, n * joints * 3),
    weights: floats(cursor, n * weightCount),
    root: floats(cursor, n * ROOT_SIZE),
    phase: floats(cursor, n * layers),
    blend: floats(cursor, n * layers),
    state: new Uint32Array(cursor.buffer, cursor.at, n * layers),
  };
  cursor.at += n * layers * 4;
  return frame;
}

function hex32(value: number): string {
  return value.toString(16).padStart(8, "0");
}

/** Says whether `buffer` begins with GLB's magic number. */
export function isGlb(buffer: ArrayBuffer): boolean {
  return buffer.byteLength >= 12 && new DataView(buffer).getUint32(0, true) === 0x46546c67;
}

/** Returns the tick of a pose frame, or null if `buffer` is no pose frame. */
export function tickOfPose(buffer: ArrayBuffer): number | null {
  const view = new DataView(buffer);
  return buffer.byteLength >= HEADER_BYTES && view.getUint32(0, true) === MAGIC
    ? view.getUint32(8, true)
    : null;
}

/** Reads a pose frame. Throws WireError on a wrong magic number, a wrong length, or a message cut short. */
export function readPoseFrame(buffer: ArrayBuffer): PoseFrame {
  if (buffer.byteLength < HEADER_BYTES) throw new WireError("frame is shorter than its header");
  const view = new DataView(buffer);
  const word = (at: number): number => view.getUint32(at, true);
  if (word(0) !== MAGIC) throw new WireError(`not a pose frame: magic ${hex32(word(0))}`);
  if (word(28) !== buffer.byteLength)
    throw new WireError(`frame says ${word(28)} bytes, has ${buffer.byteLength}`);
  const cursor: Cursor = { buffer, at: HEADER_BYTES };
  const casts: CastFrame[] = [];
  for (let i = 0; i < word(24); i++) casts.push(readCast(cursor));
  return {
    epoch: word(4),
    tick: word(8),
    head: word(12),
    hash: hex32(word(20)) + hex32(word(16)),
    bytes: buffer.byteLength,
    casts,
  };
}
