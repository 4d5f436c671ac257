/** Where bones end that no other bone begins at: head, hands, feet. A glTF joint has a place and no length; its skin tells. */

import * as THREE from "three";
import type { CastHello } from "../net/protocol";
import type { BonePlan } from "./bones";
import type { Model } from "./model";

/** The end of the bone of joint `joint`, in the joint's own space. */
export interface BoneEnd {
  joint: number;
  at: THREE.Vector3;
}

/** A vertex that hangs on `node` more than on all others, in that node's own space. */
type Visit = (node: THREE.Object3D, vertex: THREE.Vector3) => void;

const vertex = new THREE.Vector3();
/** Joints of this name end the bone before them and have none of their own. */
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

/** The joint of a skin that a rigid part hangs on, as a helmet does; else the part itself. */
function holder(mesh: THREE.Object3D): THREE.Object3D {
  for (let at: THREE.Object3D | null = mesh; at; at = at.parent) if (at instanceof THREE.Bone) return at;
  return mesh;
}

function ofPart(mesh: THREE.Mesh, visit: Visit): void {
  const position = mesh.geometry.getAttribute("position");
  const node = holder(mesh);
  const toNode = node.matrixWorld.clone().invert().multiply(mesh.matrixWorld);
  for (let i = 0; i < position.count; i++) visit(node, vertex.fromBufferAttribute(position, i).applyMatrix4(toNode));
}

function eachVertex(scene: THREE.Object3D, visit: Visit): void {
  scene.traverse((object) => {
    if (object instanceof THREE.SkinnedMesh) ofSkin(object, visit);
    else if (object instanceof THREE.Mesh) ofPart(object, visit);
  });
}

/** For each node that holds skin: how far that reaches towards its middle, seen from the node. */
export function skinEnds(scene: THREE.Object3D): Map<THREE.Object3D, THREE.Vector3> {
  scene.updateMatrixWorld(true);
  const ways = new Map<THREE.Object3D, THREE.Vector3>();
  eachVertex(scene, (node, at) => void ways.set(node, (ways.get(node) ?? new THREE.Vector3()).add(at)));
  const reach = new Map<THREE.Object3D, number>();
  for (const way of ways.values()) way.normalize();
  eachVertex(scene, (node, at) => void reach.set(node, Math.max(reach.get(node) ?? 0, at.dot(ways.get(node)!))));
  for (const [node, way] of ways) way.multiplyScalar(reach.get(node)!);
  return ways;
}

/** Straight on from the joint before it, half as far, as the model stands in its file. */
function straightOn(joint: THREE.Object3D, before: THREE.Object3D): THREE.Vector3 {
  const back = joint.worldToLocal(new THREE.Vector3().setFromMatrixPosition(before.matrixWorld));
  return back.multiplyScalar(-0.5);
}

/** The ends of the bones that have no bone after them. */
export function boneEnds(plan: BonePlan, cast: Pick<CastHello, "nodes" | "names">, model: Pick<Model, "scene" | "nodes" | "skinEnds">): BoneEnd[] {
  const before = new Map(plan.segments.map(([from, to]) => [to, from]));
  const goesOn = new Set(plan.segments.map(([from]) => from));
  const object = (joint: number): THREE.Object3D | undefined => model.nodes[cast.nodes[joint]!];
  model.scene.updateMatrixWorld(true);
  return plan.joints.flatMap((joint) => {
    const [own, last] = [object(joint), object(before.get(joint) ?? -1)];
    if (goesOn.has(joint) || !own) return [];
    const skin = model.skinEnds.get(own);
    if (skin?.lengthSq()) return [{ joint, at: skin }];
    // A goal or a pole of inverse kinematics hangs on no bone that moves skin, and is none itself.
    const moves = last && (model.skinEnds.has(last) || !model.skinEnds.size);
    return moves && !MARKER.test(cast.names[joint] ?? "") ? [{ joint, at: straightOn(own, last) }] : [];
  });
}
