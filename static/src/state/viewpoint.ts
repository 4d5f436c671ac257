/** From where this page looks at its actor: as numbers of the address. */

import { signal } from "@preact/signals-core";

/**
 * `follow` moves with the character, `free` stays where it is; `front`, `side` and `top` move and turn with the
 * character.
 */
export type CameraMode = "follow" | "free" | "front" | "side" | "top";

export const CAMERA_MODES: readonly CameraMode[] = ["follow", "free", "front", "side", "top"];

export class Viewpoint {
  readonly mode = signal<CameraMode>("follow");
  /** Where the user has put the camera, relative to the actor; null: as the page frames it. */
  readonly chosen = signal<readonly number[] | null>(null);
  /** Undefined: nothing is asked for. */
  private asked: readonly number[] | null | undefined;

  /** Asks for a viewpoint in the next drawing of the actor. */
  ask(camera: readonly number[] | null): void {
    this.asked = camera;
  }

  /** Whether `ask` was called since the camera last framed the actor. */
  get isAsked(): boolean {
    return this.asked !== undefined;
  }

  /** Whether the user, or the address, has put the camera somewhere. */
  get isChosen(): boolean {
    return (this.asked ?? this.chosen.value) !== null;
  }

  /** Takes what was asked for; later framings are the page's own. */
  take(): readonly number[] | null {
    this.chosen.value = this.asked ?? null;
    this.asked = undefined;
    return this.chosen.value;
  }
}
