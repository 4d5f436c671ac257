/** What lies over the picture: the live state with its progress, the modes of the skin, the choice of stream, notices. */

import type { Session } from "../session";
import type { Modes, Picture } from "../view/picture";
import { el, say } from "./dom";
import { icon } from "./icons";

const MODES: [keyof Modes, string, string][] = [
  ["skin", "1", "the skin with its materials"],
  ["wire", "2", "the skin's triangles"],
  ["bones", "3", "a line for each bone, a circle for each joint"],
  ["tetra", "4", "a tetrahedron for each bone"],
];

export function toggleMode(picture: Picture, mode: keyof Modes): void {
  picture.modes.set({ ...picture.modes.value, [mode]: !picture.modes.value[mode] });
}

function modeButton(picture: Picture, [mode, key, title]: (typeof MODES)[number]): HTMLButtonElement {
  const made = el("button", { type: "button", title: `${title} (${key})` }, mode);
  made.addEventListener("click", () => toggleMode(picture, mode));
  picture.modes.on((modes) => made.setAttribute("aria-pressed", String(modes[mode])));
  return made;
}

/** The bar of toggles at the foot of the picture. */
export function modeBar(host: HTMLElement, session: Session, picture: Picture): void {
  const skin = el("div", { class: "group", role: "group", "aria-label": "what is drawn" }, ...MODES.map((mode) => modeButton(picture, mode)));
  const streams = (["pose", "glb"] as const).map((kind) => {
    const title = kind === "pose" ? "the browser skins: local transforms are streamed" : "the server skins: each message is a complete GLB";
    const made = el("button", { type: "button", title: `${title} (G)` }, kind);
    made.addEventListener("click", () => session.stream(kind));
    session.frames.on((frames) => made.setAttribute("aria-pressed", String(frames === kind)));
    return made;
  });
  const frame = el("button", { type: "button", class: "square", "aria-label": "frame the character", title: "frame the character (F)" }, icon("frame"));
  frame.addEventListener("click", () => picture.frame());
  const stream = el("div", { class: "group choice", role: "group", "aria-label": "stream" }, ...streams);
  host.append(skin, el("span", { class: "space" }), stream, el("div", { class: "group" }, frame));
}

/** The live state's name and how far its motion is. */
export class StateBadge {
  private readonly name = el("strong");
  private readonly bar = el("i");
  private readonly note = el("span", { class: "note" });

  constructor(host: HTMLElement, session: Session, picture: Picture) {
    host.append(this.name, el("span", { class: "phase", "aria-hidden": true }, this.bar), this.note);
    session.state.on((state) => say(this.name, session.stateName(state)));
    session.hello.on(() => say(this.name, session.stateName(session.state.value)));
    session.looking.on((tick) => say(this.note, tick === null ? "" : "looking back"));
    picture.loading.on((text) => say(host.parentElement!.querySelector("#loading")!, text));
  }

  /** Once a drawn frame; takes the phase 0…1 of the frame, or null where it says none. */
  update(phase: number | null): void {
    this.bar.parentElement!.hidden = phase === null;
    this.bar.style.transform = `scaleX(${(phase ?? 0).toFixed(3)})`;
  }
}

const NOTICE_MS = 6000;

/** Short messages that go by themselves; read out by screen readers. */
export function notices(host: HTMLElement, session: Session): void {
  session.notices.on((text) => {
    const note = el("p", {}, text);
    host.append(note);
    while (host.children.length > 3) host.firstElementChild?.remove();
    setTimeout(() => note.remove(), NOTICE_MS);
  });
}
