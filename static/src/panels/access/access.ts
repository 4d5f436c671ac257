/** Says what you may not do on a server that asks for tokens, and why it lets you in no more. */

import "./access.css";
import { effect } from "@preact/signals-core";
import type { Access } from "../../net/protocol";
import type { Link } from "../../net/connection";
import type { App } from "../../view/app";
import { say } from "../../ui/dom";

/** Returns the sentence about what you may do; empty if you may do everything here. */
export function accessWords(access: Access | null, link: { state: Link; detail: string }): string {
  if (link.state === "refused") return link.detail;
  if (access?.role === "view") return "you may only look";
  if (access?.stage) return "you may drive this stage";
  return access?.role === "drive" ? "you may look and drive" : "";
}

/** Shows the sentence in the header. */
export function accessPanel(host: HTMLElement, { session, line }: App): void {
  effect(() => {
    const access = session.access.value;
    const words = accessWords(access, line.link.value);
    say(host, words);
    host.hidden = !words;
    host.title = access?.name ? `${access.name}: role ${access.role}` : words;
  });
}
