/** Buttons and keys for what the timeline shows: how long a part, which lanes, which events. */

import { effect, type Signal, signal } from "@preact/signals-core";
import { el, say } from "../../ui/dom";
import type { App } from "../../view/app";
import { layersOf } from "./laneRows";

/** A key zooms by this factor, and moves by this share of what is shown. */
const [ZOOM, PAN] = [1.6, 0.25];

/** Returns a length in words: `2 min`, `12 s`, `0.5 s`. */
export function lengthWords(seconds: number): string {
  if (seconds >= 90) return `${Math.round(seconds / 60)} min`;
  return `${seconds >= 10 ? Math.round(seconds) : Number(seconds.toFixed(1))} s`;
}

function button(text: string, title: string, act: () => void): HTMLButtonElement {
  const made = el("button", { type: "button", class: "plain", title }, text);
  made.addEventListener("click", act);
  return made;
}

function toggle(text: string, title: string, on: Signal<boolean>): HTMLButtonElement {
  const made = button(text, title, () => (on.value = !on.value));
  on.subscribe((pressed) => made.setAttribute("aria-pressed", String(pressed)));
  return made;
}

/** Fills the tools of the timeline; returns whether a drag selects. */
export function windowControls(tools: HTMLElement, app: App): { selecting: Signal<boolean> } {
  const { timeline, commands, stage, frame, selection } = app;
  const selecting = signal(false);
  const recentOrAll = (): void => (timeline.isAll ? timeline.recent() : timeline.all());
  const shown = button("", "how much of the history is shown", recentOrAll);
  shown.classList.add("zoom");
  const filter = el("input", {
    type: "search",
    class: "text-input event-filter",
    placeholder: "filter events",
    "aria-label": "filter the events of the timeline",
  });
  filter.addEventListener("input", () => (timeline.filter.value = filter.value));
  for (const kind of ["keydown", "keyup"] as const)
    filter.addEventListener(kind, (press) => press.key !== "Escape" && press.stopPropagation());
  const foldAll = (): void => timeline.foldAll(layersOf(selection.cast));
  const fold = button("fold", "states alone (J); a click on a lane's name folds that lane", foldAll);
  effect(() => {
    const isFolded = layersOf(selection.cast).every((name) => timeline.folded.value.has(name));
    fold.setAttribute("aria-pressed", String(isFolded));
  });
  tools.append(
    shown,
    toggle("select", "a drag over the lanes selects a span (or shift and drag; keys I and K)", selecting),
    fold,
    filter,
  );
  commands.add(
    { keys: ["+", "="], words: "timeline: zoom in", act: () => timeline.zoom(1 / ZOOM) },
    { keys: ["-"], words: "timeline: zoom out", act: () => timeline.zoom(ZOOM) },
    { keys: ["["], words: "timeline: earlier", act: () => timeline.pan(-PAN) },
    { keys: ["]"], words: "timeline: later", act: () => timeline.pan(PAN) },
    { keys: ["i"], words: "timeline: the span begins here", act: () => timeline.mark("from") },
    { keys: ["k"], words: "timeline: the span ends here", act: () => timeline.mark("to") },
    { keys: ["u"], words: "timeline: loop the span", act: () => timeline.loop() },
    {
      keys: ["j"],
      words: "timeline: fold the lanes",
      act: foldAll,
    },
  );
  frame.on(() => {
    const { from, to } = timeline.span;
    const words = timeline.isAll ? "all" : lengthWords((to - from) / stage.rate);
    say(shown, words);
    const name = timeline.isAll ? "all of the history" : `${words} of the history`;
    if (shown.ariaLabel !== name) shown.ariaLabel = name;
  });
  return { selecting };
}
