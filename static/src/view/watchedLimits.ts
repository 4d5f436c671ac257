/** The limits of the watched actor's joints, drawn anew when the actor, the machine or the joint changes. */

import type { JointLimit } from "../net/protocol";
import { token } from "../ui/dom";
import { type LimitMark, LimitOverlay } from "./limitOverlay";
import type { PosedModel } from "./posedModel";
import type { Scene } from "./scene";

export class WatchedLimits {
  private overlay: LimitOverlay | null = null;

  constructor(private readonly scene: Scene) {}

  /** Draws the limits of an actor, `joint`'s limits more strongly; nothing without an actor or limits. */
  draw(actor: PosedModel | null, limits: readonly JointLimit[], joint: string, isShown: boolean): void {
    this.drop();
    if (!actor || !limits.length) return;
    this.overlay = new LimitOverlay(actor, this.scene.renderer.getPixelRatio());
    this.colour();
    this.overlay.take(limits);
    this.overlay.select(joint);
    this.overlay.show(isShown);
    this.scene.world.add(this.overlay.object);
    this.scene.invalidate();
  }

  drop(): void {
    this.overlay?.dispose();
    this.overlay = null;
  }

  /** Follows the actor's pose. */
  update(): void {
    this.overlay?.update();
  }

  /** Applies the theme's colours. */
  colour(): void {
    this.overlay?.colour(token("--ink"), token("--accent"));
  }

  /** The limits that can be seen. */
  marks(): LimitMark[] {
    return this.overlay?.marks() ?? [];
  }

  /** The joints that have limits. */
  jointNames(): string[] {
    return this.overlay?.jointNames() ?? [];
  }
}
