/** Keeps the keyboard free for the character. */

/** Dialogs, fields of forms, and popovers used by keys keep their focus: their keys are not for the character. */
const keepsFocus = (element: Element): boolean =>
  element.closest("dialog, .field") !== null ||
  (element.closest("[popover]") !== null && element.matches(":focus-visible"));

/** Gives the keyboard back to the character. */
export function releaseFocus(): void {
  if (document.activeElement instanceof HTMLElement) document.activeElement.blur();
}

/** What Escape leaves when nothing in it or around it has another use for the key. */
const LEFT_BY_ESCAPE = "button, select, a, input[type=range]";

/** Takes the focus off a clicked button or select, a dragged slider, and what a user leaves by Escape: it would catch
 * the character's keys. */
export function freeFocus(): void {
  document.addEventListener("keydown", (press) => {
    const { target } = press;
    if (press.key !== "Escape" || press.defaultPrevented || !(target instanceof HTMLElement)) return;
    if (target !== document.activeElement || !target.matches(LEFT_BY_ESCAPE) || keepsFocus(target)) return;
    press.stopPropagation(); // a machine may have Escape among its keys
    releaseFocus();
  });
  document.addEventListener("click", (click) => {
    const button = click.target instanceof Element ? click.target.closest("button") : null;
    if (button && click.detail > 0 && !keepsFocus(button)) button.blur();
  });
  document.addEventListener("change", ({ target }) => {
    if (target instanceof HTMLSelectElement && !keepsFocus(target)) target.blur();
  });
  document.addEventListener("pointerup", ({ target }) => {
    if (target instanceof HTMLInputElement && target.type === "range" && !keepsFocus(target)) target.blur();
  });
}
