/** The level of detail: a slider by hand, or by the size on screen; and what is drawn, in words. */

import type { Crowd } from "../../view/crowd";
import type { StageView } from "../../view/stageView";
import { el, say } from "../../ui/dom";
import { controlLine } from "../../ui/popover";

/** 4079 triangles, 0.0075 metres -> `4,079 triangles, off by 7.5 mm`. */
export function detailWords(triangles: number, error_m: number): string {
  const drawn = `${triangles.toLocaleString("en")} triangles`;
  return error_m > 0 ? `${drawn}, off by ${(1000 * error_m).toFixed(1)} mm` : drawn;
}

function trianglesOf(crowd: Crowd, level: number): number {
  const corners = crowd.levels[level]!.bodies.map(({ geometry }) => geometry.index?.count ?? 0);
  return Math.round(corners.reduce((all, count) => all + count, 0) / 3);
}

/** Makes the slider, the button for the size on screen, and the words; hidden where a model has no levels. */
export function detailControls(stageView: StageView): HTMLElement {
  const { byHand } = stageView.detail;
  const title = "how many triangles the watched character is drawn with";
  const slider = el("input", { type: "range", min: "0", step: "1", "aria-label": "detail", title });
  const bySize = el("button", { type: "button", title: "as coarse as the size on screen allows" }, "by size");
  const words = el("output", { class: "detail-words" });
  const line = controlLine("detail", slider, bySize, words);
  line.classList.add("detail");
  line.hidden = true;
  slider.addEventListener("input", () => (byHand.value = Number(slider.max) - Number(slider.value)));
  bySize.addEventListener(
    "click",
    () => (byHand.value = byHand.value === null ? stageView.watched.shownLevel : null),
  );
  byHand.subscribe((level) => bySize.setAttribute("aria-pressed", String(level === null)));
  let shown = "";
  stageView.scene.drawing.on(() => {
    const crowd = stageView.watched.cast?.crowd;
    const levels = crowd?.model.levels ?? [];
    const level = stageView.watched.shownLevel;
    const key = `${crowd?.model.url} ${level}`;
    if (key === shown) return;
    shown = key;
    line.hidden = !levels.length;
    if (!crowd || !levels.length) return;
    slider.max = String(levels.length);
    slider.value = String(levels.length - level);
    say(words, detailWords(trianglesOf(crowd, level), levels[level - 1]?.error_m ?? 0));
  });
  return line;
}
