/** Draws the ghost: the actors of another stage, translucent. */

import { Vector3, type Camera } from "three";
import type { State } from "../state/state";
import type { Casting } from "./casting";
import { themeColours } from "./castView";
import type { Scene } from "./scene";

/** Whether one of the points (x, y, z, x, …; metres) is drawn inside the picture. */
export function isInPicture(points: Float32Array, camera: Camera): boolean {
  const point = new Vector3();
  for (let at = 0; at < points.length; at += 3) {
    const { x, y, z } = point.fromArray(points, at).project(camera);
    if (Math.max(Math.abs(x), Math.abs(y)) <= 1 && Math.abs(z) <= 1) return true;
  }
  return false;
}

/** A ghost that is at most so many seconds from the wanted tick has arrived there. */
const NEAR_S = 0.25;

export class GhostView {
  /** The tick that is drawn; -1: none. */
  posed = -1;
  private isOutside = false;

  constructor(
    private readonly scene: Scene,
    private readonly state: State,
    readonly casting: Casting,
  ) {
    casting.built.on(() => this.dress());
    state.ghost.hello.subscribe((hello) => {
      this.posed = -1;
      this.isOutside = false;
      if (hello) void casting.take(hello);
      else casting.leave();
      scene.invalidate();
    });
  }

  /** Shows the newest frame, if the models are loaded. */
  update(): void {
    const { ghost } = this.state;
    const { pose } = ghost;
    ghost.follow();
    if (!pose || !this.casting.actors.size) return;
    ghost.pose = null;
    this.casting.casts.forEach((cast, c) => cast.take(pose.casts[c]!));
    this.posed = pose.tick;
    this.tell();
    this.scene.invalidate();
  }

  /**
   * Says so, once, when the ghost of the watched actor is nowhere in the picture. The first frame is the newest of the
   * ghost's stage, and a jump leaves the ghost behind for a moment: there it may be anywhere.
   */
  private tell(): void {
    const { ghost, notices, selection, stage } = this.state;
    const actor = this.casting.actors.get(selection.actor.value ?? -1);
    if (!actor || Math.abs(this.posed - ghost.wanted) > NEAR_S * stage.rate) return;
    const joints = actor.jointPositions(new Float32Array(actor.cast.joints * 3));
    const isOutside = !isInPicture(joints, this.scene.view.camera);
    if (isOutside && !this.isOutside) notices.emit("The ghost is outside the picture: F frames both.");
    this.isOutside = isOutside;
  }

  /** Makes the skins translucent, in the theme's colours. */
  dress(): void {
    for (const cast of this.casting.casts) {
      cast.show({ skin: true, wire: false, ghost: true }, false, null);
      cast.colour(themeColours());
    }
  }
}
