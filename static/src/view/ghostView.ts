/** Draws the ghost: the actors of another stage, translucent. */

import type { State } from "../state/state";
import type { Casting } from "./casting";
import { themeColours } from "./castView";
import type { Scene } from "./scene";

export class GhostView {
  /** The tick that is drawn; -1: none. */
  posed = -1;

  constructor(
    private readonly scene: Scene,
    private readonly state: State,
    readonly casting: Casting,
  ) {
    casting.built.on(() => this.dress());
    state.ghost.hello.subscribe((hello) => {
      this.posed = -1;
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
    this.scene.invalidate();
  }

  /** Makes the skins translucent, in the theme's colours. */
  dress(): void {
    for (const cast of this.casting.casts) {
      cast.show({ skin: true, wire: false, ghost: true }, false, null);
      cast.colour(themeColours());
    }
  }
}
