/** From where this page looks at its actor: as numbers of the address. */

import { signal } from "@preact/signals-core";

export class Viewpoint {
  /** Where the user has put the camera, relative to the actor; null: as the page frames it. */
  readonly chosen = signal<readonly number[] | null>(null);
  private asked: readonly number[] | null = null;

  /** Asks for a viewpoint as soon as an actor is framed. */
  ask(camera: readonly number[] | null): void {
    this.asked = camera;
  }

  /** Takes what was asked for; later framings are the page's own. */
  take(): readonly number[] | null {
    this.chosen.value = this.asked;
    this.asked = null;
    return this.chosen.value;
  }
}
