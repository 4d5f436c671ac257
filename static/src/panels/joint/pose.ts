/** A joint's turn and place in numbers, from its parent and on the stage. */

import * as THREE from "three";
import type { PosedModel } from "../../view/posedModel";

const ZERO = /^-(0\.?0*)$/;

/** Writes a number without a sign before zero. */
const fixed = (value: number, digits: number): string => value.toFixed(digits).replace(ZERO, "$1");

/** Returns turns about X, Y and Z, in this order, degrees. */
export function turnsOf(quaternion: THREE.Quaternion): [number, number, number] {
  const { x, y, z } = new THREE.Euler().setFromQuaternion(quaternion, "XYZ");
  return [THREE.MathUtils.radToDeg(x), THREE.MathUtils.radToDeg(y), THREE.MathUtils.radToDeg(z)];
}

/** Returns a pose in words: `local 12.0° -3.1° 4.0° at 0.120 0.000 0.300 m`. */
export function poseWords(name: string, place: THREE.Vector3, quaternion: THREE.Quaternion): string {
  const turns = turnsOf(quaternion).map((turn) => `${fixed(turn, 1)}°`);
  const metres = place.toArray().map((value) => fixed(value, 3));
  return `${name} ${turns.join(" ")} at ${metres.join(" ")} m`;
}

/** Returns the words of an actor's joint; none if the model has no such joint. */
export function jointWords(actor: PosedModel, joint: number): string[] {
  const local = actor.local(joint);
  if (!local) return [];
  const [place, turn, scale] = [new THREE.Vector3(), new THREE.Quaternion(), new THREE.Vector3()];
  new THREE.Matrix4().fromArray(actor.jointWorld(joint)).decompose(place, turn, scale);
  return [poseWords("local", local.position, local.quaternion), poseWords("world", place, turn)];
}
