/** Draws the limits of an actor's joints: arcs of hinges and twists, cones of swings, rails of slides (SK6). */

import * as THREE from "three";
import type { JointLimit } from "../net/protocol";
import { boneEnds } from "./boneEnds";
import { planBones } from "./bones";
import { circleMaterial } from "./overlays";
import type { Local } from "./jointValues";
import { limitShape } from "./limitShapes";
import type { PosedModel } from "./posedModel";

interface Drawn {
  limit: JointLimit;
  joint: number;
  parent: number;
  group: THREE.Group;
  /** From the parent of the joint to its frame at rest, sized to the bone. */
  frame: THREE.Matrix4;
  /** The end of bone B, in the joint's own space. */
  tip: THREE.Vector3;
  /** Its direction at rest, in the joint's frame. */
  bone: THREE.Vector3;
}

/** The limits of a joint, as they are drawn. */
export interface LimitMark {
  limit: JointLimit;
  /** The place of the joint, metres. */
  place: THREE.Vector3;
  /** Its pose from its parent. */
  local: Local;
  /** From the shape of the limits, whose sizes are in bone lengths, to the scene. */
  frame: THREE.Matrix4;
  bone: THREE.Vector3;
  metres: number;
}

export class LimitOverlay {
  readonly object = new THREE.Group();
  private drawn: Drawn[] = [];
  private limits: readonly JointLimit[] = [];
  /** The joint whose limits alone are drawn; empty: those of all joints. */
  private only = "";
  private readonly circles: THREE.Points<THREE.BufferGeometry, THREE.ShaderMaterial>;
  private readonly lines = new THREE.LineBasicMaterial({ transparent: true, depthTest: false });
  private readonly faces = new THREE.MeshBasicMaterial({
    transparent: true,
    opacity: 0.16,
    side: THREE.DoubleSide,
    depthWrite: false,
  });
  /** From each joint to the end of its bone: where in its limits it is. */
  private readonly needles = new THREE.LineSegments(new THREE.BufferGeometry(), this.lines);

  constructor(
    private readonly actor: PosedModel,
    pixelRatio: number,
  ) {
    this.object.visible = false;
    this.circles = new THREE.Points(new THREE.BufferGeometry(), circleMaterial(pixelRatio));
    this.circles.frustumCulled = false;
    this.circles.renderOrder = 13;
    this.needles.frustumCulled = false;
    this.needles.renderOrder = 12;
  }

  /** Takes the limits to draw. */
  take(limits: readonly JointLimit[]): void {
    if (limits === this.limits) return;
    this.limits = limits;
    this.clear();
    const ends = this.ends();
    for (const limit of limits) {
      const joint = this.actor.cast.names.indexOf(limit.joint);
      if (!this.actor.has(joint)) continue;
      const tip = ends.get(joint) ?? new THREE.Vector3(0, 0.1, 0);
      this.drawn.push(this.made(limit, joint, this.actor.cast.parents[joint]!, tip));
    }
    const points = new THREE.BufferAttribute(new Float32Array(this.drawn.length * 6), 3);
    this.needles.geometry.setAttribute("position", points);
    this.circles.geometry.setAttribute(
      "position",
      new THREE.BufferAttribute(new Float32Array(this.drawn.length * 3), 3),
    );
    this.object.add(this.needles, this.circles, ...this.drawn.map(({ group }) => group));
    this.select(this.only);
  }

  /** Draws the limits of one joint only, or of all joints (empty). */
  select(joint: string): void {
    this.only = joint;
    for (const { limit, group } of this.drawn) group.visible = !joint || limit.joint === joint;
  }

  /** Returns the limits that can be seen. */
  marks(): LimitMark[] {
    if (!this.object.visible) return [];
    return this.drawn
      .filter(({ group }) => group.visible)
      .flatMap(({ limit, joint, group, tip, bone }) => {
        const local = this.actor.local(joint);
        if (!local) return [];
        const place = new THREE.Vector3().setFromMatrixPosition(
          new THREE.Matrix4().fromArray(this.actor.jointWorld(joint)),
        );
        return [{ limit, place, local, frame: group.matrix, bone, metres: tip.length() }];
      });
  }

  /** The joints with limits, while limits are shown. */
  jointNames(): string[] {
    return this.object.visible ? this.drawn.map(({ limit }) => limit.joint) : [];
  }

  private ends(): Map<number, THREE.Vector3> {
    const { cast, model } = this.actor;
    const plan = planBones(cast, model.skinJoints);
    const ends = new Map(boneEnds(plan, cast, model).map(({ joint, at }) => [joint, at]));
    for (const [from, to] of plan.segments) {
      const at = this.actor.local(to)?.position;
      if (at?.lengthSq() && !ends.has(from)) ends.set(from, at);
    }
    return ends;
  }

  private made(limit: JointLimit, joint: number, parent: number, tip: THREE.Vector3): Drawn {
    const [tx, ty, tz, ...turn] = limit.rest as [number, number, number, number, number, number, number];
    const frame = new THREE.Quaternion(...(limit.frame as [number, number, number, number]));
    const length = tip.length();
    const bone = tip.clone().normalize().applyQuaternion(frame.clone().invert());
    const { lines, faces } = limitShape(limit, bone, length);
    const group = new THREE.Group();
    const points = (values: number[]): THREE.BufferGeometry =>
      new THREE.BufferGeometry().setAttribute("position", new THREE.Float32BufferAttribute(values, 3));
    group.add(new THREE.Mesh(points(faces), this.faces), new THREE.LineSegments(points(lines), this.lines));
    group.children.forEach((part, k) => Object.assign(part, { frustumCulled: false, renderOrder: 11 + k }));
    group.matrixAutoUpdate = false;
    const matrix = new THREE.Matrix4().compose(
      new THREE.Vector3(tx, ty, tz),
      new THREE.Quaternion(...turn).multiply(frame),
      new THREE.Vector3().setScalar(length),
    );
    return { limit, joint, parent, group, frame: matrix, tip, bone };
  }

  /** Follows the actor's joints, whose world matrices are up to date. */
  update(): void {
    if (!this.object.visible || !this.drawn.length) return;
    const points = this.needles.geometry.getAttribute("position") as THREE.BufferAttribute;
    const circles = this.circles.geometry.getAttribute("position") as THREE.BufferAttribute;
    const [world, end] = [new THREE.Matrix4(), new THREE.Vector3()];
    this.drawn.forEach(({ joint, parent, group, frame, tip }, k) => {
      group.matrix.fromArray(this.actor.jointWorld(parent)).multiply(frame);
      group.matrixWorldNeedsUpdate = true;
      world.fromArray(this.actor.jointWorld(joint));
      end.setFromMatrixPosition(world).toArray(points.array, 6 * k);
      end.toArray(circles.array, 3 * k);
      end
        .copy(tip)
        .multiplyScalar(0.7)
        .applyMatrix4(world)
        .toArray(points.array, 6 * k + 3);
    });
    points.needsUpdate = circles.needsUpdate = true;
  }

  /** Shows or hides the limits. */
  show(shown: boolean): void {
    this.object.visible = shown;
    this.update();
  }

  colour(ink: string, accent: string): void {
    const { ink: ring, paper } = this.circles.material.uniforms as Record<
      string,
      THREE.IUniform<THREE.Color>
    >;
    ring!.value.set(ink);
    paper!.value.set(accent);
    this.lines.color.set(accent);
    this.faces.color.set(accent);
  }

  private clear(): void {
    this.object.clear();
    for (const { group } of this.drawn)
      group.traverse((part) => {
        (part as Partial<THREE.Mesh>).geometry?.dispose();
      });
    this.drawn = [];
  }

  dispose(): void {
    this.clear();
    this.object.removeFromParent();
    this.needles.geometry.dispose();
    this.circles.geometry.dispose();
    this.circles.material.dispose();
    this.lines.dispose();
    this.faces.dispose();
  }
}
