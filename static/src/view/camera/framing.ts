/** Staging: how much of the character, or of what is around it, the camera shows. */

import * as THREE from "three";
import type { PosedModel } from "../posedModel";
import type { Framing } from "./framingChoice";

/** The part of the size that is shown around a chosen joint. */
const AROUND_JOINT = 0.3;
/** The part of the height, from the top, that a framing shows. */
const PART: Readonly<Record<Framing, number>> = { whole: 1, "upper body": 0.5, face: 0.2, wide: 1 };
export const FRAMINGS = Object.keys(PART) as Framing[];
const WIDE = 2.5;
/** The part of the height above a whole character, for its head at the apex of a jump. */
const HEADROOM = 0.16;
/** Actors within this distance, in sizes of the watched actor, are framed with it. */
const COMPANY_REACH = 3;

/** Returns the box to frame, of the box of the character around its root. */
export function framed(box: THREE.Box3, framing: Framing): THREE.Box3 {
  if (framing === "whole") return box.clone();
  const size = box.getSize(new THREE.Vector3());
  if (framing === "wide") return box.clone().expandByVector(size.multiplyScalar((WIDE - 1) / 2));
  const high = size.y * PART[framing];
  const centre = box.getCenter(new THREE.Vector3()).setY(box.max.y - high / 2);
  const wide = Math.min(Math.max(size.x, size.z), 1.2 * high);
  return new THREE.Box3().setFromCenterAndSize(centre, new THREE.Vector3(wide, high, wide));
}

/** Returns the box around a joint, of the box of the character; both around the root. */
export function aroundJoint(box: THREE.Box3, joint: THREE.Vector3): THREE.Box3 {
  const edge = AROUND_JOINT * box.getSize(new THREE.Vector3()).length();
  return new THREE.Box3().setFromCenterAndSize(joint, new THREE.Vector3().setScalar(edge));
}

/** Returns a box with room above for a jump. */
export function withHeadroom(box: THREE.Box3): THREE.Box3 {
  const { min, max } = box;
  return box.clone().expandByPoint(max.clone().setY(max.y + HEADROOM * (max.y - min.y)));
}

/** Returns a box around an actor's root, made to hold the actor's ghost as well, however far it is. */
export function withGhost(actor: PosedModel, box: THREE.Box3, ghost: PosedModel): THREE.Box3 {
  return box.clone().union(ghost.box().translate(ghost.position.sub(actor.position)));
}

/** Returns the box of an actor and the actors near it, around its root; `own`: its own box. */
export function withCompany(actor: PosedModel, own: THREE.Box3, others: readonly PosedModel[]): THREE.Box3 {
  const reach = own.getSize(new THREE.Vector3()).length() * COMPANY_REACH;
  const near = new THREE.Box3().setFromCenterAndSize(
    new THREE.Vector3(),
    new THREE.Vector3().setScalar(2 * reach),
  );
  const all = own.clone();
  const place = actor.position;
  const company = others.filter((other) => near.containsPoint(other.position.sub(place)));
  for (const other of company) all.union(other.box(company.length).translate(other.position.sub(place)));
  return all;
}
