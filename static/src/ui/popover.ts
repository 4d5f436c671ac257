/** A button that opens a box of controls beside it; Escape, a click elsewhere and the button close it. */

import "./popover.css";
import { el } from "./dom";

/** Pixels between the box and what is around it. */
const GAP = 8;

/** Puts the box where more room is, above the button or below it. */
function place(box: HTMLElement, button: HTMLElement): void {
  const { left, top, bottom } = button.getBoundingClientRect();
  const [above, below] = [top - 2 * GAP, innerHeight - bottom - 2 * GAP];
  const isAbove = above >= below;
  Object.assign(box.style, {
    left: `${Math.max(GAP, Math.min(left, innerWidth - box.offsetWidth - GAP))}px`,
    top: isAbove ? "auto" : `${bottom + GAP}px`,
    bottom: isAbove ? `${innerHeight - top + GAP}px` : "auto",
    maxHeight: `${isAbove ? above : below}px`,
  });
}

/** Makes the button and its box; the browser opens, closes, and gives the focus back. */
export function popover(
  name: string,
  title: string,
  ...controls: HTMLElement[]
): [HTMLButtonElement, HTMLElement] {
  const id = `${name}-popover`;
  const facts = { id, class: "popover", popover: "auto", role: "group", "aria-label": title };
  const box = el("div", facts, ...controls);
  const button = el("button", { type: "button", popovertarget: id, title }, name);
  const put = (): void => place(box, button);
  const sizes = new ResizeObserver(put);
  // Placed before it opens, so that it is never seen elsewhere; its width, which moves it left, is known later.
  box.addEventListener("beforetoggle", put);
  box.addEventListener("toggle", () => {
    const isOpen = box.matches(":popover-open");
    button.setAttribute("aria-expanded", String(isOpen));
    sizes.disconnect();
    if (isOpen) for (const element of [box, document.body]) sizes.observe(element);
  });
  button.setAttribute("aria-expanded", "false");
  // The character would take the key for its own.
  document.addEventListener("keydown", (press) => {
    if (press.key === "Escape" && box.matches(":popover-open")) press.stopPropagation();
  });
  return [button, box];
}

/** Makes a line of the box: the words of a control, and the control. */
export function controlLine(words: string, ...controls: HTMLElement[]): HTMLElement {
  return el("div", { class: "control-line" }, el("span", { "aria-hidden": "true" }, words), ...controls);
}
