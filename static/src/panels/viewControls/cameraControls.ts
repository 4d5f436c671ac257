/** Chooses the camera: what it does while the character moves, from which side, and how much it shows. */

import type { Command } from "../../state/commands";
import { el } from "../../ui/dom";
import { type IconName, icon } from "../../ui/icons";
import { controlLine } from "../../ui/popover";
import { CAMERA_MODES, type CameraMode } from "../../state/viewpoint";
import { FRAMINGS } from "../../view/camera/framing";
import type { StageView } from "../../view/stageView";
import { choice } from "./choice";

const KEYS: Readonly<Record<CameraMode, string>> = {
  follow: "6",
  front: "7",
  side: "8",
  top: "9",
  free: "0",
};

/** Lists the commands of the camera, for keys, palette and help. */
export function cameraCommands({ scene, watched }: StageView): Command[] {
  const modes = CAMERA_MODES.map((mode) => ({
    keys: [KEYS[mode]],
    words: `camera: ${mode}`,
    act: () => (scene.view.mode.value = mode),
  }));
  const framings = FRAMINGS.map((framing) => ({
    keys: [],
    words: `framing: ${framing}`,
    act: () => watched.framing.choose(framing),
  }));
  return [
    { keys: ["f"], words: "frame the character, or the chosen joint", act: () => watched.frameChosen() },
    { keys: ["r"], words: "turntable", act: () => (watched.turning.value = !watched.turning.value) },
    ...modes,
    ...framings,
  ];
}

function button(name: IconName, words: string, key: string, act: () => void): HTMLButtonElement {
  const facts = { type: "button", class: "square", "aria-label": words, title: `${words} (${key})` };
  const made = el("button", facts, icon(name));
  made.addEventListener("click", act);
  return made;
}

/** Makes the button that turns the view around the character. */
function turntable({ turning }: StageView["watched"]): HTMLButtonElement {
  const made = button("turn", "turntable", "R", () => (turning.value = !turning.value));
  turning.subscribe((on) => made.setAttribute("aria-pressed", String(on)));
  return made;
}

/** Makes the buttons of the camera that need no choice. */
export function cameraButtons({ watched }: StageView): HTMLElement[] {
  return [
    turntable(watched),
    button("frame", "frame the character, or the chosen joint", "F", () => watched.frameChosen()),
  ];
}

/** Makes the choices of camera and framing. */
export function cameraControls({ scene, watched }: StageView): HTMLElement[] {
  const title =
    "follow moves with the character, free stays where it is, front, side and top turn with it (6 to 0)";
  const framing = choice("framing", "how much the camera shows", FRAMINGS, watched.framing.shown, (name) =>
    watched.framing.choose(name),
  );
  return [
    controlLine("camera", choice("camera", title, CAMERA_MODES, scene.view.mode)),
    controlLine("framing", framing),
  ];
}
