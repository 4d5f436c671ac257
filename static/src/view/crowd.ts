/** All actors of a cast: their poses, and what draws them with one call for each material. */

import * as THREE from "three";
import type { CastHello, Skinning } from "../net/protocol";
import type { CastFrame } from "../net/wire";
import type { Body } from "./bodies";
import { CastPose } from "./castPose";
import { CrowdLevel, type Detail } from "./crowdLevel";
import { type Parts, partsOf } from "./crowdParts";
import { weightsOf } from "./heat";
import { levelIndex } from "./levelIndex";
import type { Model } from "./model";
import { PoseTexture } from "./poseTexture";
import { growBox } from "./posedVertices";

/** Returns the triangles of parts after the steps below `steps`. */
const trianglesAfter = (steps: number): Detail =>
  steps ? ({ geometry, sources }) => levelIndex(geometry, sources, steps) : () => null;

export class Crowd {
  readonly pose: CastPose;
  readonly texture: PoseTexture;
  readonly parts: Parts;
  /** The levels of detail; the first one is the whole skin. */
  readonly levels: readonly CrowdLevel[];
  /** Returns the level of an actor at a distance from the camera, metres. */
  levelAt: (distance_m: number, camera: THREE.PerspectiveCamera) => number = () => 0;
  /** Contains the bodies; at the origin of the stage, as the matrices of the poses are. */
  readonly root = new THREE.Group();
  /** How the vertices follow the joints. */
  way: Skinning = "linear";
  /** The level of each actor, by its row. */
  shownLevels: readonly number[] = [];
  private order = "";

  constructor(
    readonly cast: CastHello,
    readonly model: Model,
    shadows: boolean,
  ) {
    const ids = cast.actors.map(({ id }) => id);
    this.parts = partsOf(model);
    const jointOf = new Map(cast.nodes.map((node, joint) => [node, joint]));
    const follows = this.parts.follows.map(({ node, inverse }) => ({
      joint: jointOf.get(node) ?? -1,
      inverse,
    }));
    this.pose = new CastPose(ids.length, cast.parents);
    this.texture = new PoseTexture(ids.length, follows, cast.weights);
    this.levels = [0, ...model.levels.map(({ steps }) => steps)].map(
      (steps) => new CrowdLevel(this.parts.parts, ids, this.texture, trianglesAfter(steps)),
    );
    for (const body of this.bodies) {
      Object.assign(body, { castShadow: shadows, receiveShadow: shadows });
      this.root.add(body);
    }
    this.root.visible = false; // until the first frame: the bind pose is not shown
    this.skin(cast.skinning);
  }

  /** What the crowd is drawn with: of each level one body for each part. */
  get bodies(): Body[] {
    return this.levels.flatMap(({ bodies }) => bodies);
  }

  /** Vertices of one actor. */
  get vertices(): number {
    return this.parts.parts.reduce((all, { geometry }) => all + geometry.getAttribute("position").count, 0);
  }

  /** Skins in a way. */
  skin(way: Skinning): void {
    if (way === this.way) return;
    this.way = way;
    this.texture.turning = way === "dual-quaternion";
    for (const level of this.levels) level.skin(way);
    if (this.pose.frame) this.texture.fill(this.pose);
  }

  /** Shows the poses of a frame. */
  take(frame: CastFrame): void {
    this.pose.take(frame);
    this.texture.fill(this.pose);
    this.root.visible = true;
  }

  /** Takes the matrices of an actor from the server, which skins; the own skin is hidden. */
  place(row: number, matrices: Float32Array | undefined): void {
    this.root.visible = false;
    this.pose.place(row, matrices);
  }

  /** Gives each level the actors that it draws, in the order of their distance; called before each drawing. */
  arrange(camera: THREE.PerspectiveCamera): void {
    if (!this.root.visible) return;
    const { x, y, z } = camera.position;
    const { pose } = this;
    const distances = this.cast.actors.map((_, row) => {
      const at = pose.indexOf(row, -1) + 12;
      return Math.hypot(pose.matrices[at]! - x, pose.matrices[at + 1]! - y, pose.matrices[at + 2]! - z);
    });
    const rows = [...distances.keys()].sort((a, b) => distances[a]! - distances[b]!);
    const levels = rows.map((row) => this.levelAt(distances[row]!, camera));
    this.shownLevels = rows.map((_, row) => levels[rows.indexOf(row)]!);
    const order = `${rows.join()} ${levels.join()}`;
    if (order === this.order) return;
    this.order = order;
    this.levels.forEach((level, l) => level.take(rows.filter((_, k) => levels[k] === l)));
  }

  /** Adds the posed vertices of an actor, every `step`th, to a box. */
  addSkin(box: THREE.Box3, row: number, step: number): void {
    if (!this.pose.frame) this.texture.fillRow(this.pose, row);
    const pose = this.texture.numbers.subarray(row * this.texture.stride, (row + 1) * this.texture.stride);
    for (const { geometry, firstWeight } of this.parts.parts)
      growBox(box, geometry, pose, this.texture.weightAt(firstWeight), step);
  }

  /** Returns the shares (V) of a body's vertices that the joint of this name moves. */
  weights(body: Body, joint: string): Float32Array {
    const node = this.cast.nodes[this.cast.names.indexOf(joint)];
    const moves = this.parts.follows.map(
      (follow) => follow.node === node || this.holder(follow.node) === node,
    );
    return weightsOf(body.geometry, (follow) => moves[follow]!);
  }

  /** The bone that a rigid part hangs on. */
  private holder(node: number): number {
    const { nodes } = this.model;
    for (let at: THREE.Object3D | null = nodes[node]!; at; at = at.parent)
      if (at instanceof THREE.Bone) return nodes.indexOf(at);
    return node;
  }

  dispose(): void {
    for (const level of this.levels) level.dispose();
    this.texture.dispose();
    this.root.removeFromParent();
  }
}
