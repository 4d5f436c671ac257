/** The values of a joint's degrees of freedom, as the server defines them (docs/joints.md), from its pose. */

import * as THREE from "three";
import type { JointLimit } from "../net/protocol";

const DEGREES = 180 / Math.PI;

/** A joint's place and turn from its parent. */
export interface Local {
  position: THREE.Vector3;
  quaternion: THREE.Quaternion;
}

/** Returns rest translation, rest rotation and the joint's frame. */
export function restOf(limit: JointLimit): [THREE.Vector3, THREE.Quaternion, THREE.Quaternion] {
  const [x, y, z, ...turn] = limit.rest as [number, number, number, number, number, number, number];
  const frame = new THREE.Quaternion(...(limit.frame as [number, number, number, number]));
  return [new THREE.Vector3(x, y, z), new THREE.Quaternion(...turn), frame];
}

/** Returns the way and the turn of a joint from its rest pose, in its frame. */
function inFrame(limit: JointLimit, joint: Local): [THREE.Vector3, THREE.Quaternion] {
  const [place, turn, frame] = restOf(limit);
  const back = turn.clone().multiply(frame).invert();
  const way = joint.position.clone().sub(place).applyQuaternion(back);
  return [way, back.multiply(joint.quaternion).multiply(frame)];
}

/** The angle of a turn about Y, radians. */
const aboutY = ({ y, w }: THREE.Quaternion): number => 2 * Math.atan2(y, w);

/** Swing about X and Z after the twist about Y, radians. */
function swingOf(turn: THREE.Quaternion): [number, number] {
  const twist = new THREE.Quaternion(0, turn.y, 0, turn.w);
  if (twist.lengthSq() < 1e-12) twist.set(0, 0, 0, 1);
  const swing = turn.clone().multiply(twist.normalize().invert());
  const sine = Math.hypot(swing.x, swing.z);
  const angle = 2 * Math.atan2(sine, swing.w);
  return sine > 1e-12 ? [(swing.x / sine) * angle, (swing.z / sine) * angle] : [0, 0];
}

/** The angle about which a joint's turn is told, radians: of a screw by its way, else the middle of its range. */
function middleOf(limit: JointLimit, way: THREE.Vector3): number {
  if (limit.type === "helical") return (way.y / limit.pitch) * 2 * Math.PI;
  const range = limit.freedoms.find(({ name }) => name === "angle" || name === "twist");
  return ((range?.minimum ?? -180) + (range?.maximum ?? 180)) / 2 / DEGREES;
}

/** The same direction as `angle`, by whole turns as near to `middle` as it comes. */
function nearTo(middle: number, angle: number): number {
  return angle + 2 * Math.PI * Math.round((middle - angle) / (2 * Math.PI));
}

/** Slides in the plane: those after the turn turn with it. */
function slidesOf(order: string, way: THREE.Vector3, angle: number): [number, number] {
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  const turned: [number, number] = [way.x * cos - way.z * sin, way.x * sin + way.z * cos];
  if (order === "RPP") return turned;
  if (order === "PRP") return [way.x - (way.z * sin) / cos, way.z / cos];
  return [way.x, way.z];
}

/** Returns the value of each degree of freedom by its name: degrees of angles, metres of slides. */
export function freedomValues(limit: JointLimit, joint: Local): Map<string, number> {
  const [way, turn] = inFrame(limit, joint);
  const named = new Map<string, number>();
  const angle = nearTo(middleOf(limit, way), aboutY(turn));
  const [swingX, swingZ] = swingOf(turn);
  const [slideX, slideZ] = slidesOf(limit.symbol, way, angle);
  const euler = new THREE.Euler().setFromQuaternion(turn, "ZYX");
  const every: Record<string, number> = {
    angle: angle * DEGREES,
    twist: angle * DEGREES,
    slide: way.y,
    slide_x: slideX,
    slide_z: slideZ,
    swing_x: swingX * DEGREES,
    swing_z: swingZ * DEGREES,
    rotate_x: euler.x * DEGREES,
    rotate_y: euler.y * DEGREES,
    rotate_z: euler.z * DEGREES,
    translate_x: way.x,
    translate_y: way.y,
    translate_z: way.z,
  };
  for (const { name } of limit.freedoms) named.set(name, every[name] ?? 0);
  return named;
}

/** Returns a value in words: `34.2°`, `0.120 m`. */
export function valueWords(value: number, isAngle: boolean): string {
  return isAngle ? `${value.toFixed(1)}°` : `${value.toFixed(3)} m`;
}
