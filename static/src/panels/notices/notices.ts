/** Shows sentences for the user for a few seconds; screen readers read them out. */

import "./notices.css";
import type { App } from "../../view/app";
import { el } from "../../ui/dom";

const SHOWN_MS = 6000;
const MOST = 3;

export function noticesPanel(host: HTMLElement, { notices }: App): void {
  notices.on((text) => {
    const note = el("p", {}, text);
    host.append(note);
    while (host.children.length > MOST) host.firstElementChild?.remove();
    setTimeout(() => note.remove(), SHOWN_MS);
  });
}
