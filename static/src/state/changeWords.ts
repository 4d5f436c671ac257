/** Says what somebody did to a stage's time. */

import type { ClockChange } from "../net/protocol";

const WORDS = {
  paused: "You were paused by",
  resumed: "The stage was resumed by",
  speed: "The speed was changed by",
  stepped: "The stage was stepped by",
  moved: "The playhead was moved by",
} satisfies Record<ClockChange["what"], string>;

export const changeWords = ({ what, by, tick }: ClockChange): string =>
  `${WORDS[what]} ${by}, at tick ${tick}.`;
