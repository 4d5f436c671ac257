/** Shows sentences for the user for a few seconds, longer with a button, each once; screen readers read them out. */

import "./notices.css";
import type { Notice } from "../../state/notice";
import type { App } from "../../view/app";
import { el } from "../../ui/dom";

const SHOWN_MS = 6000;
/** Long enough to find the button by keyboard. */
const WITH_BUTTON_MS = 20_000;
const MOST = 3;

function noteOf(notice: Notice): HTMLElement {
  if (typeof notice === "string") return el("p", {}, notice);
  const button = el("button", { type: "button" }, notice.words);
  const note = el("p", {}, notice.text, button);
  button.addEventListener("click", () => {
    note.remove();
    notice.act();
  });
  return note;
}

export function noticesPanel(host: HTMLElement, { notices }: App): void {
  notices.on((notice) => {
    const note = noteOf(notice);
    for (const shown of [...host.children])
      if (shown.firstChild?.textContent === note.firstChild?.textContent) shown.remove();
    host.append(note);
    while (host.children.length > MOST) host.firstElementChild?.remove();
    setTimeout(() => note.remove(), typeof notice === "string" ? SHOWN_MS : WITH_BUTTON_MS);
  });
}
