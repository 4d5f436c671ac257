/** What every panel gets: the page's state, and the view of the stage. */

import { type State, makeState } from "../state/state";
import { onTheme, reducedMotion } from "../ui/dom";
import type { FollowCamera } from "./camera/followCamera";
import { chooseQuality } from "./quality";
import { Scene } from "./scene";
import { shareCamera } from "./sharedCamera";
import { teachCutaway } from "./cutaway";
import { teachSkinning } from "./skinShader";
import { StageView } from "./stageView";

export interface App extends State {
  readonly view: StageView;
}

/** Fills its element of the page, and keeps it up to date with the state. */
export type Panel = (host: HTMLElement, app: App) => void;

/** Metres between two frames: a camera that moves less rests. */
const REST_M = 1e-4;

/** Makes the state and the stage view; `renderer`: the name of the browser's renderer. */
export function makeApp(canvas: HTMLCanvasElement, renderer: string): App {
  teachSkinning();
  teachCutaway();
  const state = makeState();
  const quality = chooseQuality(renderer, location.search);
  const view = new StageView(new Scene(canvas, quality, reducedMotion), state);
  state.frame.on(() => view.update());
  const { view: camera } = view.scene;
  shareCamera(state, camera);
  camera.mode.subscribe((mode) => (state.viewpoint.mode.value = mode));
  state.viewpoint.mode.subscribe((mode) => (camera.mode.value = mode));
  noteViewpoints(state, camera);
  onTheme(() => view.recolour());
  state.scene.look.subscribe((look) => view.scene.light(look));
  return { ...state, view };
}

/** Notes from where the user looks when the camera rests after a drag or in another mode: it swings on for a moment. */
function noteViewpoints({ frame, viewpoint }: State, camera: FollowCamera): void {
  let before: number[] | null = null;
  const begin = (): void => {
    before = [];
  };
  camera.controls.addEventListener("end", begin);
  camera.mode.subscribe((mode) => mode === "follow" || begin());
  frame.on(() => {
    if (!before) return;
    const [earlier, around] = [before, camera.around];
    before = around;
    if (!around.every((metres, axis) => Math.abs(metres - (earlier[axis] ?? NaN)) < REST_M)) return;
    viewpoint.chosen.value = around;
    before = null;
  });
}
