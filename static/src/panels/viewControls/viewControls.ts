/** Controls over the stage view: what is drawn and how, the choice of stream, the camera. */

import "./viewControls.css";
import type { Skinning } from "../../net/protocol";
import type { Command } from "../../state/commands";
import type { App } from "../../view/app";
import type { Modes, StageView } from "../../view/stageView";
import { FRAMINGS, type Framing } from "../../view/framing";
import { el } from "../../ui/dom";
import { icon } from "../../ui/icons";
import { detailControls } from "./detailControls";
import { lookControls } from "./lookControls";
import { proofControls } from "./proofControls";

const MODES: [keyof Modes, string, string][] = [
  ["skin", "1", "the skin with its materials"],
  ["wire", "2", "the skin's triangles"],
  ["bones", "3", "a line for each bone, a circle for each joint"],
  ["tetra", "4", "a tetrahedron for each bone"],
  ["limits", "5", "arcs and cones of the joints' limits"],
];

/** Turns a mode on or off. */
function toggleMode(stageView: StageView, mode: keyof Modes): void {
  stageView.modes.value = { ...stageView.modes.value, [mode]: !stageView.modes.value[mode] };
}

/** Shows wire instead of the smooth skin, or the smooth skin instead of wire. */
function wireOrSkin(stageView: StageView): void {
  const { wire } = stageView.modes.value;
  stageView.modes.value = { ...stageView.modes.value, wire: !wire, skin: wire };
}

/** Fills the screen with the page, or stops it; a browser that refuses changes nothing. */
function toggleFullScreen(): Promise<void> {
  const change = document.fullscreenElement
    ? document.exitFullscreen()
    : document.documentElement.requestFullscreen();
  return change.catch(() => undefined);
}

function viewCommands({ view, frames }: App): Command[] {
  const mode = (name: keyof Modes, ...keys: string[]): Command => ({
    keys,
    words: `show ${name}`,
    act: () => toggleMode(view, name),
  });
  const { turning } = view.watched;
  return [
    { keys: ["f"], words: "frame the character", act: () => view.watched.frame() },
    mode("skin", "1"),
    mode("wire", "2"),
    mode("bones", "3", "b"),
    mode("tetra", "4"),
    mode("limits", "5"),
    { keys: ["t"], words: "wire, smooth skin", act: () => wireOrSkin(view) },
    { keys: ["m"], words: "full screen", act: () => void toggleFullScreen() },
    { keys: ["r"], words: "turntable", act: () => (turning.value = !turning.value) },
    {
      keys: ["g"],
      words: "pose stream, glb stream",
      act: () => frames.stream(frames.kind.value === "pose" ? "glb" : "pose"),
    },
  ];
}

/** Makes the button that turns the view around the character. */
function turntable(stageView: StageView): HTMLButtonElement {
  const made = el(
    "button",
    { type: "button", title: "the view turns around the character (R)" },
    "turntable",
  );
  made.addEventListener("click", () => (stageView.watched.turning.value = !stageView.watched.turning.value));
  stageView.watched.turning.subscribe((turning) => made.setAttribute("aria-pressed", String(turning)));
  return made;
}

function modeButton(stageView: StageView, [mode, key, title]: (typeof MODES)[number]): HTMLButtonElement {
  const made = el("button", { type: "button", title: `${title} (${key})` }, mode);
  made.addEventListener("click", () => toggleMode(stageView, mode));
  stageView.modes.subscribe((modes) => made.setAttribute("aria-pressed", String(modes[mode])));
  return made;
}

/** Makes the choice of how much the camera shows. */
function framingChoice(stageView: StageView): HTMLSelectElement {
  const options = FRAMINGS.map((framing) => el("option", { value: framing }, framing));
  const select = el("select", { "aria-label": "framing", title: "how much the camera shows" }, ...options);
  select.addEventListener("change", () => (stageView.watched.framing.value = select.value as Framing));
  stageView.watched.framing.subscribe((framing) => (select.value = framing));
  return select;
}

const WAYS: [Skinning | "", string][] = [
  ["", "own skin"],
  ["linear", "linear"],
  ["dual-quaternion", "dual quaternion"],
  ["rigid", "rigid"],
  ["parts", "parts"],
];

/** Makes the choice of the way of skinning. */
function skinningChoice(app: App): HTMLSelectElement {
  const title =
    "what the vertices follow: blended matrices, blended dual quaternions, one bone, or one bone a piece";
  const options = WAYS.map(([value, text]) => el("option", { value }, text));
  const select = el("select", { "aria-label": "way of skinning", title }, ...options);
  select.addEventListener("change", () => app.frames.skin((select.value || null) as Skinning | null));
  app.frames.skinning.subscribe((way) => (select.value = way ?? ""));
  return select;
}

/** Makes the choice of the joint whose path is drawn. */
function pathChoice(stageView: StageView): HTMLSelectElement {
  const none = el("option", { value: "" }, "no path");
  const select = el("select", { "aria-label": "path of a joint", title: "draw a joint's path (arc)" }, none);
  const fill = (): void => {
    const names = stageView.watched.jointNames().map((name) => el("option", { value: name }, name));
    select.replaceChildren(none, ...names);
    select.value = stageView.watched.traced.value;
  };
  select.addEventListener("pointerdown", fill);
  select.addEventListener("focus", fill);
  select.addEventListener("change", () => (stageView.watched.traced.value = select.value));
  stageView.watched.ready.subscribe(fill);
  return select;
}

/** Fills the foot of the stage view with buttons. */
export function viewControlsPanel(host: HTMLElement, app: App): void {
  const stageView = app.view;
  stageView.scene.leaveRoomFor(host);
  app.commands.add(...viewCommands(app));
  const skin = el(
    "div",
    { class: "group", role: "group", "aria-label": "what is drawn" },
    ...MODES.map((mode) => modeButton(stageView, mode)),
  );
  const streams = (["pose", "glb"] as const).map((kind) => {
    const title =
      kind === "pose"
        ? "the browser skins: local transforms are streamed"
        : "the server skins: each message is a complete GLB";
    const made = el("button", { type: "button", title: `${title} (G)` }, kind);
    made.addEventListener("click", () => app.frames.stream(kind));
    app.frames.kind.subscribe((frames) => made.setAttribute("aria-pressed", String(frames === kind)));
    return made;
  });
  const frame = el(
    "button",
    {
      type: "button",
      class: "square",
      "aria-label": "frame the character",
      title: "frame the character (F)",
    },
    icon("frame"),
  );
  frame.addEventListener("click", () => stageView.watched.frame());
  const stream = el("div", { class: "group choice", role: "group", "aria-label": "stream" }, ...streams);
  const staging = el(
    "div",
    { class: "group staging" },
    skinningChoice(app),
    pathChoice(stageView),
    framingChoice(stageView),
    turntable(stageView),
    frame,
  );
  const looks = el("div", { class: "group staging" }, ...lookControls(stageView));
  const [prove, difference] = proofControls(stageView.proof);
  staging.append(prove);
  const detail = detailControls(stageView);
  host.append(skin, looks, detail, el("span", { class: "space" }), stream, staging, difference);
}
