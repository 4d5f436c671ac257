/**
 * Tries a pose: drag the joint that you have clicked, and a line shows where its limb would go, within the limits
 * of the machine. The server solves it (inverse kinematics); nothing on the stage changes.
 */

import * as THREE from "three";
import { solve } from "../../net/api";
import { Latest } from "../../net/latest";
import type { Solved } from "../../net/protocol";
import { reasonOf } from "../../net/reason";
import type { Point } from "../../state/points";
import type { App } from "../../view/app";
import { say } from "../../ui/dom";
import { planBones } from "../../view/bones";
import { limbOf } from "../../view/limb";
import { PointHandles } from "../../view/pointHandles";
import type { PosedModel } from "../../view/posedModel";
import { TrialLine } from "../../view/trialLine";

const PER_SECOND = 20;
/** Metres: the size of the ball, as a part of the character's height. */
const SIZE = 0.018;
const HANDLE = "joint";

/** Returns the sentence about a trial. */
export function trialWords(joint: string, answer: Pick<Solved, "reached" | "distance" | "clamped">): string {
  const limits = Object.entries(answer.clamped).map(([name, angle]) => `${name} by ${angle.toFixed(1)}°`);
  const reached = answer.reached ? "reaches" : `stays ${(100 * answer.distance).toFixed(1)} cm away`;
  return `trial: ${joint} ${reached}${limits.length ? `; clamped: ${limits.join(", ")}` : ""}`;
}

export class PoseTrial {
  private readonly handles: PointHandles;
  private readonly line = new TrialLine();
  private readonly sender = new Latest<Point>((point) => void this.ask(point), PER_SECOND);
  private shown: string | null = null;
  private asking = false;
  /** The newest place that came during a request. */
  private waiting: Point | null = null;
  private size = 0;

  constructor(
    private readonly host: HTMLElement,
    private readonly app: App,
  ) {
    const { scene, watched } = app.view;
    this.handles = new PointHandles(scene, (_, point) => this.sender.put(point));
    scene.world.add(this.line.object);
    watched.joint.subscribe(() => this.end());
  }

  /** Shows the ball at the chosen joint, if nothing else moves it; called once per drawn frame. */
  update(hasHandles: boolean): void {
    const limb = hasHandles ? null : this.limb();
    if (!limb) {
      if (this.shown !== null) this.end();
      return;
    }
    const { actor, joints } = limb;
    if (this.shown !== this.app.view.watched.joint.value) {
      const box = actor.box();
      this.size = SIZE * Math.max(box.max.y - box.min.y, 0.1);
    }
    this.shown = this.app.view.watched.joint.value;
    if (this.handles.dragging !== null || !this.host.hidden) return;
    const e = actor.jointWorld(joints.at(-1)!);
    this.handles.show(HANDLE, [e[12]!, e[13]!, e[14]!], this.size);
  }

  private limb(): { actor: PosedModel; joints: number[] } | null {
    const actor = this.app.view.watched.model;
    const joint = actor?.cast.names.indexOf(this.app.view.watched.joint.value) ?? -1;
    if (!actor || joint < 0 || actor.cast.muscle_bones.includes(joint)) return null;
    const { joints } = planBones(actor.cast, actor.model.skinJoints);
    const bones = joints.filter((each) => !actor.cast.muscle_bones.includes(each));
    const limb = limbOf(joint, actor.cast.parents, new Set(bones));
    return limb.length > 1 ? { actor, joints: limb } : null;
  }

  /** Asks the server where the limb goes. */
  private async ask(point: Point): Promise<void> {
    const found = this.limb();
    const machine = this.app.machine.info.value;
    this.waiting = this.asking ? point : null;
    if (!found || !machine || this.asking) return;
    const { actor, joints } = found;
    const names = actor.cast.names;
    const inside = new THREE.Vector3(...point).applyMatrix4(actor.rootWorld().invert());
    this.asking = true;
    try {
      const answer = await solve(machine.character, {
        chain: [names[joints[0]!]!, names[joints.at(-1)!]!],
        target: inside.toArray(),
        solver: "ccd",
        iterations: 100,
        machine: machine.name,
        pose: poseAbove(actor, joints.at(-1)!),
      });
      if (this.shown === null) return;
      this.line.show(
        answer.joints.map(({ position }) => new THREE.Vector3(...position).applyMatrix4(actor.rootWorld())),
      );
      this.host.hidden = false;
      say(this.host, trialWords(names[joints.at(-1)!]!, answer));
      this.app.view.scene.invalidate();
    } catch (error) {
      this.app.notices.emit(reasonOf(error));
    } finally {
      this.asking = false;
      if (this.waiting !== null) void this.ask(this.waiting);
    }
  }

  private end(): void {
    this.shown = null;
    this.host.hidden = true;
    this.handles.clear();
    this.line.show([]);
    this.app.view.scene.invalidate();
  }
}

type Quaternion = [number, number, number, number];

/** The shown pose of a joint and of all joints above it: what a chain down to it depends on. */
function poseAbove(
  actor: PosedModel,
  joint: number,
): { rotations: Record<string, Quaternion>; translations: Record<string, Point> } {
  const rotations: Record<string, Quaternion> = {};
  const translations: Record<string, Point> = {};
  for (let at = joint; at >= 0; at = actor.cast.parents[at] ?? -1) {
    const local = actor.local(at);
    const name = actor.cast.names[at]!;
    if (!local) continue;
    const { x, y, z, w } = local.quaternion;
    rotations[name] = [x, y, z, w];
    translations[name] = local.position.toArray();
  }
  return { rotations, translations };
}
