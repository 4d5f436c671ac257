/** Reads and writes the ground speed of a state; reading throws errors with words for the user. */

import type { StateInfo } from "../../net/protocol";
import { listed, numberOrNone, numberText } from "../../state/fieldTexts";

type GroundSpeed = StateInfo["ground_speed"];

/** Reads metres a second forward, `x, z`, or `found`; blank: null, which takes the ground speed away. */
export function groundSpeedOf(text: string): number | GroundSpeed {
  if (text.trim() === "found") return "found";
  const [x = null, z = null, ...others] = listed(text).map(numberOrNone);
  if (others.length) throw new Error("metres a second forward, or x, z");
  return x !== null && z !== null ? [x, z] : x;
}

/** Writes a ground speed; a way straight ahead is one number. */
export function groundSpeedText(speed: GroundSpeed): string {
  if (speed === null || speed === "found") return speed ?? "";
  const [x, z] = speed;
  return x === 0 ? numberText(z) : `${numberText(x)}, ${numberText(z)}`;
}
