/**
 * Poses a clone of a model: its nodes take the frame's local transforms, the GPU skins. If the server skins,
 * only its root and the matrices of its joints follow the frame.
 */

import * as THREE from "three";
import type { CastHello } from "../net/protocol";
import type { CastFrame } from "../net/wire";
import { type Model, instance } from "./model";

interface MorphSlice {
  meshes: THREE.Mesh[];
  first: number;
  count: number;
}

function meshesOf(node: THREE.Object3D): THREE.Mesh[] {
  const own = node instanceof THREE.Mesh ? [node as THREE.Mesh] : [];
  // three makes a group of a mesh with several primitives; the meshes in it have no node.
  const inner =
    node instanceof THREE.Group
      ? node.children.filter((child): child is THREE.Mesh => child instanceof THREE.Mesh)
      : [];
  return [...own, ...inner].filter((mesh) => mesh.morphTargetInfluences !== undefined);
}

/**
 * Returns the place of each node's morph weights in a row of the frame: in the order of the nodes, one per
 * target.
 */
function morphSlices(nodes: (THREE.Object3D | null)[], targets: number[]): MorphSlice[] {
  let next = 0;
  const firsts = targets.map((count) => (next += count) - count);
  return nodes.flatMap((node, i) =>
    node && targets[i] ? [{ meshes: meshesOf(node), first: firsts[i]!, count: targets[i] }] : [],
  );
}

export class PosedModel {
  /** Has the actor's place in the stage; contains the model. */
  readonly root = new THREE.Group();
  /** The object of every joint, in the order of the hello. */
  readonly joints: (THREE.Object3D | null)[];
  readonly meshes: THREE.Mesh[] = [];
  private readonly morphs: MorphSlice[];
  /** The joints' world matrices (J, 16) that the server gave, or null if the objects have them. */
  private worlds: Float32Array | null = null;

  constructor(
    readonly id: number,
    readonly cast: CastHello,
    readonly model: Model,
    shadows: boolean,
  ) {
    const { scene, nodes } = instance(model);
    this.root.add(scene);
    this.joints = cast.nodes.map((node) => nodes[node] ?? null);
    this.morphs = morphSlices(nodes, model.targets);
    for (const joint of this.joints) if (joint) joint.matrixAutoUpdate = false;
    scene.traverse((object) => this.prepare(object, shadows));
  }

  private prepare(object: THREE.Object3D, shadows: boolean): void {
    if (!(object instanceof THREE.Mesh)) return;
    // The skin leaves the box of its bind pose, so culling by that box would hide visible parts.
    object.frustumCulled = false;
    object.castShadow = shadows;
    object.receiveShadow = shadows;
    this.meshes.push(object);
  }

  /** Applies a row of the cast's frame. */
  apply(frame: CastFrame, row: number): void {
    this.worlds = null;
    const count = frame.joints;
    for (let j = 0; j < count; j++) this.pose(frame, row * count + j, this.joints[j] ?? null);
    for (const { meshes, first, count: many } of this.morphs) {
      const at = row * frame.weightCount + first;
      for (const mesh of meshes)
        for (let k = 0; k < many; k++) mesh.morphTargetInfluences![k] = frame.weights[at + k] ?? 0;
    }
    this.root.position.fromArray(frame.root, row * 7);
    this.root.quaternion.fromArray(frame.root, row * 7 + 3);
  }

  /** Takes the world matrices (1+J, 16) of root and joints, column by column; the skin stays as it is. */
  place(matrices: Float32Array): void {
    const root = new THREE.Matrix4().fromArray(matrices);
    root.decompose(this.root.position, this.root.quaternion, this.root.scale);
    this.worlds = matrices.subarray(16);
  }

  /** Gives the objects the pose whose matrices the server gave. Joints are in order, parents first. */
  private poseAsPlaced(): void {
    if (!this.worlds) return;
    this.joints.forEach((joint, j) => {
      if (!joint?.parent) return;
      joint.matrixWorld.fromArray(this.jointWorld(j));
      joint.matrix.copy(joint.parent.matrixWorld).invert().multiply(joint.matrixWorld);
    });
  }

  private pose(frame: CastFrame, index: number, joint: THREE.Object3D | null): void {
    if (!joint) return;
    joint.position.fromArray(frame.translation, index * 3);
    joint.quaternion.fromArray(frame.rotation, index * 4);
    joint.scale.fromArray(frame.scale, index * 3);
    joint.updateMatrix();
  }

  /** Returns the box of the posed skin around the actor's root, metres. */
  box(): THREE.Box3 {
    this.root.updateWorldMatrix(true, true);
    this.poseAsPlaced();
    const box = new THREE.Box3().setFromObject(this.root, true);
    return box.isEmpty()
      ? new THREE.Box3(new THREE.Vector3(-0.5, 0, -0.5), new THREE.Vector3(0.5, 1.8, 0.5))
      : box.translate(this.root.position.clone().negate());
  }

  /** Returns a joint's place and turn from its parent; null: the model has no such joint. */
  local(joint: number): { position: THREE.Vector3; quaternion: THREE.Quaternion } | null {
    const object = this.joints[joint];
    if (!object) return null;
    if (!this.worlds) return object;
    const parent = this.joints.indexOf(object.parent);
    const above = parent < 0 ? this.root.matrixWorld.elements : this.jointWorld(parent);
    const matrix = new THREE.Matrix4().fromArray(above).invert();
    matrix.multiply(new THREE.Matrix4().fromArray(this.jointWorld(joint)));
    const [position, quaternion] = [new THREE.Vector3(), new THREE.Quaternion()];
    matrix.decompose(position, quaternion, new THREE.Vector3());
    return { position, quaternion };
  }

  /** Returns the elements of a joint's world matrix; a joint outside the scene is at the root. */
  jointWorld(joint: number): ArrayLike<number> {
    return (
      this.worlds?.subarray(joint * 16, joint * 16 + 16) ??
      (this.joints[joint] ?? this.root).matrixWorld.elements
    );
  }

  /** Writes the joints' world positions (J, 3), metres, into `out`. */
  jointPositions(out: Float32Array): Float32Array {
    this.joints.forEach((_, j) => {
      const e = this.jointWorld(j);
      out.set([e[12]!, e[13]!, e[14]!], j * 3);
    });
    return out;
  }
}
