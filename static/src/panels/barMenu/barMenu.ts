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

/** The menu is in `host`, the last of the header's children; it hides while there is room for all of them. */
export function barMenuPanel(host: HTMLElement): void {
  const bar = host.parentElement!;
  const all = foldables(bar);
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

  function fit(): void {
    const focused = document.activeElement;
    all.forEach(unfold);
    host.hidden = true;
    for (const next of [...all].sort((a, b) => orderOf(a) - orderOf(b))) {
      if (bar.scrollWidth <= bar.clientWidth) break;
      host.hidden = false;
      fold(next, menu, all);
    }
    if (focused instanceof HTMLElement && focused !== document.activeElement)
      (menu.contains(focused) && menu.hidden ? button : focused).focus({ preventScroll: true });
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
  document.addEventListener("pointerdown", ({ target }) => {
    if (!menu.hidden && target instanceof Node && !host.contains(target)) show(false);
  });
  const sizes = new ResizeObserver(fit);
  sizes.observe(bar);
  for (const child of bar.querySelectorAll(":scope > :not([data-fold])"))
    if (child !== host) sizes.observe(child);
}
