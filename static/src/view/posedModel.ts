/** An actor as it stands: the places of its joints, and the box of its skin. */

import * as THREE from "three";
import type { CastHello } from "../net/protocol";
import type { Crowd } from "./crowd";
import type { Model } from "./model";

/** With more vertices than this only every second, third … vertex counts for a box. */
const BOX_VERTICES = 200_000;

export class PosedModel {
  constructor(
    readonly id: number,
    private readonly crowd: Crowd,
    /** Of the actor in its cast. */
    readonly row: number,
  ) {}

  get cast(): CastHello {
    return this.crowd.cast;
  }

  get model(): Model {
    return this.crowd.model;
  }

  /** The actor's place in the stage, metres. */
  get position(): THREE.Vector3 {
    return new THREE.Vector3().setFromMatrixPosition(this.rootWorld());
  }

  /** Heading, radians about +Y; 0 is +Z. */
  get heading(): number {
    const root = this.crowd.pose.world(this.row, -1);
    return Math.atan2(root[8]!, root[10]!);
  }

  /** The world matrix of the actor's root. */
  rootWorld(): THREE.Matrix4 {
    return new THREE.Matrix4().fromArray(this.crowd.pose.world(this.row, -1));
  }

  /** Whether the model has this joint in its scene. */
  has(joint: number): boolean {
    return (
      joint >= 0 && joint < this.cast.joints && this.crowd.model.nodes[this.cast.nodes[joint]!] !== undefined
    );
  }

  /** Returns the elements of a joint's world matrix; of joint -1: of the root's. */
  jointWorld(joint: number): ArrayLike<number> {
    return this.crowd.pose.world(this.row, joint);
  }

  /** Returns a joint's place and turn from its parent; null: the model has no such joint. */
  local(joint: number): { position: THREE.Vector3; quaternion: THREE.Quaternion } | null {
    if (!this.has(joint)) return null;
    const [position, quaternion] = [new THREE.Vector3(), new THREE.Quaternion()];
    const { frame } = this.crowd.pose;
    if (frame) {
      const at = this.row * frame.joints + joint;
      position.fromArray(frame.translation, 3 * at);
      return { position, quaternion: quaternion.fromArray(frame.rotation, 4 * at) };
    }
    const above = this.jointWorld(this.cast.parents[joint]!);
    const matrix = new THREE.Matrix4().fromArray(above).invert();
    matrix.multiply(new THREE.Matrix4().fromArray(this.jointWorld(joint)));
    matrix.decompose(position, quaternion, new THREE.Vector3());
    return { position, quaternion };
  }

  /** Writes the joints' world positions (J, 3), metres, into `out`. */
  jointPositions(out: Float32Array): Float32Array {
    for (let joint = 0; joint < this.cast.joints; joint++) {
      const e = this.jointWorld(joint);
      out.set([e[12]!, e[13]!, e[14]!], joint * 3);
    }
    return out;
  }

  /** Returns the box of the posed skin around the actor's root, metres; `among` actors are measured. */
  box(among = 1): THREE.Box3 {
    const box = new THREE.Box3();
    if (this.model.wrong) return box.setFromObject(this.model.scene);
    this.crowd.addSkin(box, this.row, Math.ceil((among * this.crowd.vertices) / BOX_VERTICES));
    if (!this.crowd.bodies.length) this.addJoints(box);
    return box.isEmpty()
      ? new THREE.Box3(new THREE.Vector3(-0.5, 0, -0.5), new THREE.Vector3(0.5, 1.8, 0.5))
      : box.translate(this.position.negate());
  }

  /** A model without meshes is as large as its skeleton. */
  private addJoints(box: THREE.Box3): void {
    const places = this.jointPositions(new Float32Array(this.cast.joints * 3));
    box.setFromArray(places).expandByScalar(0.05 * Math.max(0.1, box.getSize(new THREE.Vector3()).length()));
  }
}
