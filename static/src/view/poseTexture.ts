/**
 * Holds the poses of all actors of a cast in one float texture, from which the vertex shader reads
 * (`skinShader.ts`). Each actor has, one after the other, the matrices that its vertices follow, four texels
 * each, and its morph weights, four in a texel.
 */

import * as THREE from "three";
import { type CastPose, multiplyInto } from "./castPose";
import { closestRotation } from "./closestRotation";

/** What a vertex can follow: a joint, and the matrix (16) from the vertex's space to the joint's at rest. */
export interface Follow {
  joint: number;
  inverse: ArrayLike<number>;
}

const WIDEST = 4096;
const TEXEL = 4;
const MATRIX = 16;

/** A skeleton is what three's renderer takes a bone texture from. */
export class PoseTexture extends THREE.Skeleton {
  /** RGBA, from the first actor on. */
  readonly numbers: Float32Array;
  /** Whether the last row of each matrix holds its rotation, for dual quaternions. */
  turning = false;
  /** Numbers for each actor: whole matrices. */
  readonly stride: number;

  constructor(
    actors: number,
    private readonly follows: readonly Follow[],
    private readonly weights: number,
  ) {
    super([], []);
    this.stride = MATRIX * (follows.length + Math.ceil(weights / MATRIX));
    const texels = Math.max(TEXEL, (actors * this.stride) / TEXEL);
    // A matrix does not continue in the next row of texels.
    const width = Math.min(WIDEST, TEXEL * Math.ceil(Math.sqrt(texels) / TEXEL));
    const height = Math.ceil(texels / width);
    this.numbers = new Float32Array(width * height * TEXEL);
    const texture = new THREE.DataTexture(this.numbers, width, height, THREE.RGBAFormat, THREE.FloatType);
    this.boneTexture = texture;
  }

  /** The texel where an actor's pose begins. */
  start(row: number): number {
    return (row * this.stride) / TEXEL;
  }

  /** The number of a pose where a morph weight is. */
  weightAt(weight: number): number {
    return MATRIX * this.follows.length + weight;
  }

  /** Takes the poses of all actors. */
  fill(pose: CastPose): void {
    for (let row = 0; row < pose.actors; row++) this.fillRow(pose, row);
    this.boneTexture!.needsUpdate = true;
  }

  /** Takes the pose of one actor, without telling the GPU. */
  fillRow(pose: CastPose, row: number): void {
    const { numbers, follows, stride, weights, turning } = this;
    const { matrices, frame } = pose;
    const first = row * stride;
    for (let k = 0; k < follows.length; k++) {
      const { joint, inverse } = follows[k]!;
      const at = first + MATRIX * k;
      multiplyInto(numbers, at, matrices, pose.indexOf(row, joint), inverse, 0);
      if (turning) this.turn(at);
    }
    for (let k = 0; frame && k < weights; k++)
      numbers[first + this.weightAt(k)] = frame.weights[row * frame.weightCount + k] ?? 0;
  }

  /** Writes the rotation of a matrix into its last row. */
  private turn(at: number): void {
    const turn = closestRotation(this.numbers, at);
    for (let k = 0; k < 4; k++) this.numbers[at + 4 * k + 3] = turn[k]!;
  }

  /** The matrices follow the cast's frames, not the renderer's. */
  override update(): void {
    // `fill` has written everything.
  }
}
