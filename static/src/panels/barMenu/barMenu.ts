/** Folds what has no room in the header into a menu at its end. */

import "../../ui/menu.css";
import "./barMenu.css";
import { el } from "../../ui/dom";
import { icon } from "../../ui/icons";
import { stepThrough } from "../../ui/menuKeys";

/** A control of the header that may be folded, and the mark of its place there. */
interface Foldable {
  control: HTMLElement;
  place: Comment;
}

const orderOf = ({ control }: Foldable): number => Number(control.dataset["fold"]);

/** Finds the controls that say when they fold: `data-fold="1"` is the first. */
function foldables(bar: HTMLElement): Foldable[] {
  return [...bar.querySelectorAll<HTMLElement>("[data-fold]")].map((control) => {
    const place = document.createComment("");
    control.before(place);
    return { control, place };
  });
}

function unfold({ control, place }: Foldable): void {
  control.removeAttribute("role");
  place.after(control);
}

/** Puts a control into the menu, where the order of the header stays. */
function fold({ control, place }: Foldable, menu: HTMLElement, all: readonly Foldable[]): void {
  const later = all.slice(all.findIndex((other) => other.place === place) + 1);
  const next = later.find((other) => other.control.parentElement === menu);
  control.setAttribute("role", "menuitem");
  menu.insertBefore(control, next?.control ?? null);
}

/** Folds as little as needed: nothing of the header is cut. `host` has the menu, and hides while it is empty. */
function fit(bar: HTMLElement, host: HTMLElement, menu: HTMLElement, all: readonly Foldable[]): void {
  const focused = document.activeElement;
  all.forEach(unfold);
  host.hidden = true;
  for (const next of [...all].sort((a, b) => orderOf(a) - orderOf(b))) {
    if (bar.scrollWidth <= bar.clientWidth) break;
    host.hidden = false;
    fold(next, menu, all);
  }
  if (focused instanceof HTMLElement && focused !== document.activeElement)
    (menu.contains(focused) && menu.hidden ? host.querySelector("button")! : focused).focus();
}

/** Makes the button and its menu; the keyboard works both. */
function hangMenu(host: HTMLElement): HTMLElement {
  const menu = el("div", { class: "menu bar-menu", role: "menu", "aria-label": "more", hidden: true });
  const button = el(
    "button",
    { type: "button", class: "plain square", "aria-label": "more", "aria-haspopup": "menu" },
    icon("lines"),
  );
  host.append(button, menu);

  function show(open: boolean): void {
    menu.hidden = !open;
    button.setAttribute("aria-expanded", String(open));
  }

  function toggle(): void {
    show(menu.hidden);
    (menu.hidden ? button : menu.querySelector<HTMLElement>("[role=menuitem]"))?.focus();
  }

  button.addEventListener("click", toggle);
  // Before the control acts: a dialog that it opens gives the focus back to the button.
  menu.addEventListener("click", toggle, { capture: true });
  host.addEventListener("keydown", (press) => {
    if (menu.hidden) return;
    press.stopPropagation();
    if (press.key === "Escape" || press.key === "Tab") toggle();
    else if (!stepThrough(menu, press)) return;
    press.preventDefault();
  });
  show(false);
  document.addEventListener("pointerdown", ({ target }) => {
    if (!menu.hidden && target instanceof Node && !host.contains(target)) show(false);
  });
  return menu;
}

/** `host` is the last of the header's children. */
export function barMenuPanel(host: HTMLElement): void {
  const bar = host.parentElement!;
  const [menu, all] = [hangMenu(host), foldables(bar)];
  const sizes = new ResizeObserver(() => fit(bar, host, menu, all));
  sizes.observe(bar);
  for (const child of bar.querySelectorAll(":scope > :not([data-fold])"))
    if (child !== host) sizes.observe(child);
}
