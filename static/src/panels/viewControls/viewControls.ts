/** Controls over the stage view: what is drawn and how, the choice of stream, the camera. */

import "./viewControls.css";
import type { Skinning } from "../../net/protocol";
import type { Command } from "../../state/commands";
import type { App } from "../../view/app";
import type { Modes, StageView } from "../../view/stageView";
import { el } from "../../ui/dom";
import { controlLine, popover } from "../../ui/popover";
import { cameraButtons, cameraCommands, cameraControls } from "./cameraControls";
import { detailControls } from "./detailControls";
import { foldInto } from "./foldInto";
import { hiddenNote } from "./hiddenNote";
import { lookControls } from "./lookControls";
import { proofControls } from "./proofControls";

const MODES: [keyof Modes, string, string][] = [
  ["skin", "1", "the skin with its materials"],
  ["wire", "2", "the skin's triangles"],
  ["bones", "3", "a line for each bone, a circle for each joint"],
  ["tetra", "4", "a tetrahedron for each bone"],
  ["limits", "5", "arcs and cones of the joints' limits"],
];

const WAYS: [Skinning | "", string][] = [
  ["", "own skin"],
  ["linear", "linear"],
  ["dual-quaternion", "dual quaternion"],
  ["rigid", "rigid"],
  ["parts", "parts"],
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
  const { proof } = view;
  const mode = (name: keyof Modes, ...keys: string[]): Command => ({
    keys,
    words: `show ${name}`,
    act: () => toggleMode(view, name),
  });
  return [
    mode("skin", "1"),
    mode("wire", "2"),
    mode("bones", "3", "b"),
    mode("tetra", "4"),
    mode("limits", "5"),
    { keys: ["t"], words: "wire, smooth skin", act: () => wireOrSkin(view) },
    { keys: ["m"], words: "full screen", act: () => void toggleFullScreen() },
    {
      keys: ["g"],
      words: "pose stream, glb stream",
      act: () => frames.stream(frames.kind.value === "pose" ? "glb" : "pose"),
    },
    {
      keys: [],
      words: "curves: the same keys by eight interpolations",
      act: () => location.assign("curves.html"),
    },
    {
      keys: [],
      words: "prove: compare the GPU's vertices with the server's",
      act: () => (proof.on.value = !proof.on.value),
    },
    ...WAYS.map(([way, text]) => ({
      keys: [],
      words: `skinning: ${text}`,
      act: () => frames.skin(way || null),
    })),
  ];
}

function modeButton(stageView: StageView, [mode, key, title]: (typeof MODES)[number]): HTMLButtonElement {
  const made = el("button", { type: "button", title: `${title} (${key})` }, mode);
  made.addEventListener("click", () => toggleMode(stageView, mode));
  stageView.modes.subscribe((modes) => made.setAttribute("aria-pressed", String(modes[mode])));
  return made;
}

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
  stageView.watched.traced.subscribe(fill);
  return select;
}

/** Makes the button that shows light and background. */
function pictureButton({ inspection: { isSceneShown } }: App): HTMLButtonElement {
  const made = el("button", { type: "button", title: "light and background (V)" }, "picture");
  made.addEventListener("click", () => (isSceneShown.value = !isSceneShown.value));
  isSceneShown.subscribe((shown) => made.setAttribute("aria-expanded", String(shown)));
  return made;
}

/** Makes the choice of the stream. */
function streamChoice({ frames }: App): HTMLElement {
  const streams = (["pose", "glb"] as const).map((kind) => {
    const title =
      kind === "pose"
        ? "the browser skins: local transforms are streamed"
        : "the server skins: each message is a complete GLB";
    const made = el("button", { type: "button", title: `${title} (G)` }, kind);
    made.addEventListener("click", () => frames.stream(kind));
    frames.kind.subscribe((shown) => made.setAttribute("aria-pressed", String(shown === kind)));
    return made;
  });
  return el("div", { class: "group choice", role: "group", "aria-label": "stream" }, ...streams);
}

/** Fills the foot of the stage view with one row of buttons. */
export function viewControlsPanel(host: HTMLElement, app: App): void {
  const stageView = app.view;
  stageView.scene.leaveRoomFor(host);
  app.commands.add(...cameraCommands(stageView), ...viewCommands(app));
  const drawn = el(
    "div",
    { class: "group", role: "group", "aria-label": "what is drawn" },
    ...MODES.map((mode) => modeButton(stageView, mode)),
  );
  const [prove, difference] = proofControls(stageView.proof);
  const picture = pictureButton(app);
  const [look, looks] = popover(
    "look",
    "how the character is drawn",
    ...lookControls(stageView),
    controlLine("skinning", skinningChoice(app)),
    controlLine("path", pathChoice(stageView)),
    detailControls(stageView),
    el("div", { class: "group" }, prove, picture),
  );
  // The box would cover what they show.
  for (const made of [picture, prove]) made.addEventListener("click", () => looks.hidePopover());
  const [camera, cameras] = popover("camera", "camera and framing", ...cameraControls(stageView));
  const aims = el("div", { class: "aims" }, ...cameraButtons(stageView));
  const more = el("div", { class: "group" }, look, camera, aims);
  const stream = streamChoice(app);
  const said = el("div", { class: "over-row" }, hiddenNote(stageView), difference);
  host.append(drawn, more, el("span", { class: "space" }), stream, looks, cameras, said);
  foldInto(host, [
    [stream, looks],
    [drawn, looks],
    [aims, cameras],
  ]);
}
