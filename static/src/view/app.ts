/** What every panel gets: the page's state, and the view of the stage. */

import { type State, makeState } from "../state/state";
import { onTheme, reducedMotion } from "../ui/dom";
import { chooseQuality } from "./quality";
import { Scene } from "./scene";
import { teachSkinning } from "./skinShader";
import { StageView } from "./stageView";

export interface App extends State {
  readonly view: StageView;
}

/** Fills its element of the page, and keeps it up to date with the state. */
export type Panel = (host: HTMLElement, app: App) => void;

const SWING_MS = 600;

/** Makes the state and the stage view; `renderer`: the name of the browser's renderer. */
export function makeApp(canvas: HTMLCanvasElement, renderer: string): App {
  teachSkinning();
  const state = makeState();
  const quality = chooseQuality(renderer, location.search);
  const view = new StageView(new Scene(canvas, quality, reducedMotion), state);
  state.frame.on(() => view.update());
  const { people, frame } = state;
  const { view: camera } = view.scene;
  frame.on(({ now }) => people.look(camera.place, now));
  people.cameras.on((place) => camera.stand(place));
  camera.controls.addEventListener("start", () => people.follow(null));
  camera.controls.addEventListener("end", () => {
    // The camera swings on for a moment.
    setTimeout(() => (state.viewpoint.chosen.value = camera.around), SWING_MS);
  });
  onTheme(() => view.recolour());
  return { ...state, view };
}
