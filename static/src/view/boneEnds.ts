/**
 * Finds the ends of the last bones: head, hands, feet. A glTF joint has no length, so the skin around it
 * gives the end.
 */

import * as THREE from "three";
import type { CastHello } from "../net/protocol";
import type { BonePlan } from "./bones";

/** The end of the bone of joint `joint`, in the joint's own space. */
export interface BoneEnd {
  joint: number;
  at: THREE.Vector3;
}

/** The part of a model that decides where bones end. */
export interface Skinned {
  scene: THREE.Object3D;
  /** By the file's index. */
  nodes: readonly THREE.Object3D[];
  /** The result of `skinEnds`. */
  skinEnds: ReadonlyMap<THREE.Object3D, THREE.Vector3>;
}

/** Gets a vertex that belongs mostly to `node`, in the node's space. */
type Visit = (node: THREE.Object3D, vertex: THREE.Vector3) => void;

const vertex = new THREE.Vector3();
/** Joints with a name like this only mark the end of the bone before them. */
const MARKER = /(^|[^A-Za-z])([Ee]nd|[Nn]ub|[Ll]eaf)$|[a-z](End|Nub)$/;

function ofSkin(mesh: THREE.SkinnedMesh, visit: Visit): void {
  const { position, skinIndex, skinWeight } = mesh.geometry.attributes;
  if (!position || !skinIndex || !skinWeight) return;
  const { bones, boneInverses } = mesh.skeleton;
  const toJoint = boneInverses.map((inverse) => inverse.clone().multiply(mesh.bindMatrix));
  for (let i = 0; i < position.count; i++) {
    for (let k = 0; k < skinWeight.itemSize; k++) {
      if (skinWeight.getComponent(i, k) < 0.5) continue;
      const bone = skinIndex.getComponent(i, k);
      visit(bones[bone]!, vertex.fromBufferAttribute(position, i).applyMatrix4(toJoint[bone]!));
      break;
    }
  }
}

/** Returns the joint that a rigid part is attached to, as a helmet to the head; else the part itself. */
function holder(mesh: THREE.Object3D): THREE.Object3D {
  for (let at: THREE.Object3D | null = mesh; at; at = at.parent) if (at instanceof THREE.Bone) return at;
  return mesh;
}

function ofPart(mesh: THREE.Mesh, visit: Visit): void {
  const position = mesh.geometry.getAttribute("position");
  const node = holder(mesh);
  const toNode = node.matrixWorld.clone().invert().multiply(mesh.matrixWorld);
  for (let i = 0; i < position.count; i++)
    visit(node, vertex.fromBufferAttribute(position, i).applyMatrix4(toNode));
}

function eachVertex(scene: THREE.Object3D, visit: Visit): void {
  scene.traverse((object) => {
    if (object instanceof THREE.SkinnedMesh) ofSkin(object as THREE.SkinnedMesh, visit);
    else if (object instanceof THREE.Mesh) ofPart(object as THREE.Mesh, visit);
  });
}

/**
 * Returns, for each node with skin, the farthest reach of the skin in the direction of its middle, in the
 * node's space.
 */
export function skinEnds(scene: THREE.Object3D): Map<THREE.Object3D, THREE.Vector3> {
  scene.updateMatrixWorld(true);
  const ways = new Map<THREE.Object3D, THREE.Vector3>();
  eachVertex(scene, (node, at) => void ways.set(node, (ways.get(node) ?? new THREE.Vector3()).add(at)));
  const reach = new Map<THREE.Object3D, number>();
  for (const way of ways.values()) way.normalize();
  eachVertex(
    scene,
    (node, at) => void reach.set(node, Math.max(reach.get(node) ?? 0, at.dot(ways.get(node)!))),
  );
  for (const [node, way] of ways) way.multiplyScalar(reach.get(node)!);
  return ways;
}

/** Continues the bone before by half its length, in the bind pose. */
function straightOn(joint: THREE.Object3D, before: THREE.Object3D): THREE.Vector3 {
  const back = joint.worldToLocal(new THREE.Vector3().setFromMatrixPosition(before.matrixWorld));
  return back.multiplyScalar(-0.5);
}

/** Returns the ends of the bones that no other bone follows. */
export function boneEnds(
  plan: BonePlan,
  cast: Pick<CastHello, "nodes" | "names">,
  model: Skinned,
): BoneEnd[] {
  const before = new Map(plan.segments.map(([from, to]) => [to, from]));
  const goesOn = new Set(plan.segments.map(([from]) => from));
  const object = (joint: number): THREE.Object3D | undefined => model.nodes[cast.nodes[joint]!];
  model.scene.updateMatrixWorld(true);
  return plan.joints.flatMap((joint) => {
    const [node, last] = [object(joint), object(before.get(joint) ?? -1)];
    if (goesOn.has(joint) || !node) return [];
    const skin = model.skinEnds.get(node);
    if (skin?.lengthSq()) return [{ joint, at: skin }];
    // IK goals and poles are no bones: their parent moves no skin.
    const moves = last && (model.skinEnds.has(last) || !model.skinEnds.size);
    return moves && !MARKER.test(cast.names[joint] ?? "") ? [{ joint, at: straightOn(node, last) }] : [];
  });
}
