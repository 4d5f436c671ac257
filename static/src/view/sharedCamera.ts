/** Shows others where this page looks from, and this page where the viewer looks from that it follows. */

import type { CameraAt } from "../net/protocol";
import type { State } from "../state/state";
import type { FollowCamera } from "./camera/followCamera";

const millimetres = (metres: number): number => Math.round(1000 * metres) / 1000;

/**
 * Shares the camera: a free one stands on the stage, every other one moves with its actor, so that nothing need be
 * told while that walks.
 */
export function shareCamera(state: State, camera: FollowCamera): void {
  const { people, selection, frame } = state;
  let isLed = false;

  function take({ actor, position, target }: CameraAt): void {
    isLed = true;
    camera.mode.value = actor === null ? "free" : "follow";
    isLed = false;
    const place = [...position, ...target];
    if (actor === null || actor === selection.actor.value) camera.lead(place);
    else watch(state, actor, place);
  }

  frame.on(({ now }) => {
    const actor = camera.mode.value === "free" ? null : selection.actor.value;
    const [x, y, z, targetX, targetY, targetZ] = camera.place.map(millimetres) as SixNumbers;
    people.look({ actor, position: [x, y, z], target: [targetX, targetY, targetZ] }, now);
  });
  people.cameras.on(take);
  camera.controls.addEventListener("start", () => people.follow(null));
  camera.mode.subscribe(() => isLed || people.follow(null));
}

type SixNumbers = [number, number, number, number, number, number];

/** Watches another actor, if the stage has it, from a place around it. */
function watch({ stage, machine, viewpoint }: State, actor: number, place: readonly number[]): void {
  const isThere = stage.hello.value?.casts.some(({ actors }) => actors.some(({ id }) => id === actor));
  if (!isThere) return;
  viewpoint.ask(place);
  void machine.choose(actor);
}
