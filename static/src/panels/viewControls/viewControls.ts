/** Controls over the stage view: the live state and its phase, skin modes, choice of stream, notices. */

import "./viewControls.css";
import type { Skinning } from "../../net/protocol";
import type { Session } from "../../state/session";
import type { Modes, StageView } from "../../view/stageView";
import { FRAMINGS, type Framing } from "../../view/framing";
import { el, say } from "../../ui/dom";
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
export function toggleMode(stageView: StageView, mode: keyof Modes): void {
  stageView.modes.set({ ...stageView.modes.value, [mode]: !stageView.modes.value[mode] });
}

/** Shows wire instead of the smooth skin, or the smooth skin instead of wire. */
export function wireOrSkin(stageView: StageView): void {
  const { wire } = stageView.modes.value;
  stageView.modes.set({ ...stageView.modes.value, wire: !wire, skin: wire });
}

/** Makes the button that turns the view around the character. */
function turntable(stageView: StageView): HTMLButtonElement {
  const made = el(
    "button",
    { type: "button", title: "the view turns around the character (R)" },
    "turntable",
  );
  made.addEventListener("click", () => stageView.watched.turning.set(!stageView.watched.turning.value));
  stageView.watched.turning.on((turning) => made.setAttribute("aria-pressed", String(turning)));
  return made;
}

function modeButton(stageView: StageView, [mode, key, title]: (typeof MODES)[number]): HTMLButtonElement {
  const made = el("button", { type: "button", title: `${title} (${key})` }, mode);
  made.addEventListener("click", () => toggleMode(stageView, mode));
  stageView.modes.on((modes) => made.setAttribute("aria-pressed", String(modes[mode])));
  return made;
}

/** Makes the choice of how much the camera shows. */
function framingChoice(stageView: StageView): HTMLSelectElement {
  const options = FRAMINGS.map((framing) => el("option", { value: framing }, framing));
  const select = el("select", { "aria-label": "framing", title: "how much the camera shows" }, ...options);
  select.addEventListener("change", () => stageView.watched.framing.set(select.value as Framing));
  stageView.watched.framing.on((framing) => (select.value = framing));
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
function skinningChoice(session: Session): HTMLSelectElement {
  const title =
    "what the vertices follow: blended matrices, blended dual quaternions, one bone, or one bone a piece";
  const options = WAYS.map(([value, text]) => el("option", { value }, text));
  const select = el("select", { "aria-label": "way of skinning", title }, ...options);
  select.addEventListener("change", () => session.skin((select.value || null) as Skinning | null));
  session.skinning.on((way) => (select.value = way ?? ""));
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
  select.addEventListener("change", () => stageView.watched.traced.set(select.value));
  stageView.watched.ready.on(fill);
  return select;
}

/** Makes the bar of buttons at the foot of the stage view. */
export function modeBar(host: HTMLElement, session: Session, stageView: StageView): void {
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
    made.addEventListener("click", () => session.stream(kind));
    session.frames.on((frames) => made.setAttribute("aria-pressed", String(frames === kind)));
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
    skinningChoice(session),
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

/** Shows the live state's name and phase. */
export class StateBadge {
  private readonly name = el("strong");
  private readonly bar = el("i");
  private readonly note = el("span", { class: "note" });

  constructor(host: HTMLElement, session: Session, stageView: StageView) {
    host.append(this.name, el("span", { class: "phase", "aria-hidden": true }, this.bar), this.note);
    session.state.on((state) => say(this.name, session.stateName(state)));
    session.hello.on(() => say(this.name, session.stateName(session.state.value)));
    session.looking.on((tick) => say(this.note, tick === null ? "" : "looking back"));
    stageView.loading.on((text) => say(host.parentElement!.querySelector("#loading")!, text));
  }

  /** Shows a phase 0…1, or none if null; called once per drawn frame. */
  update(phase: number | null): void {
    this.bar.parentElement!.hidden = phase === null;
    this.bar.style.transform = `scaleX(${(phase ?? 0).toFixed(3)})`;
  }
}

const NOTICE_MS = 6000;

/** Shows notices for a few seconds; screen readers read them out. */
export function notices(host: HTMLElement, session: Session): void {
  session.notices.on((text) => {
    const note = el("p", {}, text);
    host.append(note);
    while (host.children.length > 3) host.firstElementChild?.remove();
    setTimeout(() => note.remove(), NOTICE_MS);
  });
}
