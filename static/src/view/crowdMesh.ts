/** Draws a part of all actors of a cast at once: each instance reads its own pose from the cast's texture. */

import * as THREE from "three";
import type { Body } from "./bodies";
import type { Part } from "./crowdParts";
import type { PoseTexture } from "./poseTexture";

/**
 * A skinned mesh whose bones are in a texture only. What three asks the bones of one actor for, a crowd
 * cannot answer, and does not need: it is not culled, and is sorted by the middle of the stage.
 */
export class CrowdMesh extends THREE.SkinnedMesh {
  constructor(
    geometry: THREE.BufferGeometry,
    material: THREE.Material | THREE.Material[],
    private readonly texture: PoseTexture,
  ) {
    super(geometry, material);
    this.boundingSphere = new THREE.Sphere();
    this.frustumCulled = false;
    this.bind(texture, new THREE.Matrix4());
  }

  /** Returns another mesh of the same actors, drawn below this one. */
  twin(geometry: THREE.BufferGeometry, material: THREE.Material): CrowdMesh {
    const twin = new CrowdMesh(geometry, material, this.texture);
    twin.morphTargetInfluences = this.morphTargetInfluences;
    this.add(twin);
    return twin;
  }

  override computeBoundingSphere(): void {
    this.boundingSphere = new THREE.Sphere();
  }
}

/** Says which actors are drawn: of each instance the texel where its pose begins, and its id. */
export class Roster {
  readonly poseStart: THREE.InstancedBufferAttribute;
  readonly actorId: THREE.InstancedBufferAttribute;
  count = 0;

  constructor(
    private readonly ids: readonly number[],
    private readonly pose: PoseTexture,
  ) {
    this.poseStart = new THREE.InstancedBufferAttribute(new Float32Array(ids.length), 1);
    this.actorId = new THREE.InstancedBufferAttribute(new Float32Array(ids.length), 1);
    this.take(ids.map((_, row) => row));
  }

  /** Draws the actors of these rows of the cast, in this order. */
  take(rows: readonly number[]): void {
    rows.forEach((row, k) => {
      this.poseStart.array[k] = this.pose.start(row);
      this.actorId.array[k] = this.ids[row]!;
    });
    this.count = rows.length;
    this.poseStart.needsUpdate = this.actorId.needsUpdate = true;
  }
}

/** A geometry that is drawn once for each actor of a roster. */
export class CrowdGeometry extends THREE.InstancedBufferGeometry {
  constructor(readonly roster: Roster) {
    super();
    this.setAttribute("poseStart", roster.poseStart);
    this.setAttribute("actorId", roster.actorId);
    this.boundingSphere = new THREE.Sphere();
    Object.defineProperty(this, "instanceCount", { get: () => roster.count });
  }

  /** Takes the arrays of a geometry, and draws triangles in the order of `index`. */
  share(source: THREE.BufferGeometry, index = source.index): this {
    for (const [name, attribute] of Object.entries(source.attributes)) this.setAttribute(name, attribute);
    this.setIndex(index);
    this.morphAttributes = source.morphAttributes;
    this.morphTargetsRelative = source.morphTargetsRelative;
    for (const group of source.groups) this.addGroup(group.start, group.count, group.materialIndex);
    return this;
  }
}

/** The renderer takes lines and points with these members for skins; three has no class for them. */
function asSkin(body: THREE.Line | THREE.Points, pose: PoseTexture): Body {
  return Object.assign(body, { isSkinnedMesh: true, skeleton: pose, frustumCulled: false });
}

/** Makes the body of a part, drawn with `geometry`. */
export function bodyOf(part: Part, geometry: THREE.BufferGeometry, pose: PoseTexture): Body {
  const { like, material } = part;
  const body =
    like instanceof THREE.Mesh
      ? new CrowdMesh(geometry, material, pose)
      : asSkin(new (like.constructor as new () => THREE.Line | THREE.Points)(), pose);
  Object.assign(body, { geometry, material });
  body.updateMorphTargets();
  if (like.morphTargetDictionary) body.morphTargetDictionary = like.morphTargetDictionary; // the file's names
  // In place of its weights the uniform says where in the pose they are.
  body.morphTargetInfluences = body.morphTargetInfluences?.map((_, k) => pose.weightAt(part.firstWeight + k));
  return body;
}
