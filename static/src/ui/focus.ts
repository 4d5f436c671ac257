/** Keeps the keyboard free for the character. */

/** Dialogs, fields of forms, and popovers used by keys keep their focus: their keys are not for the character. */
const keepsFocus = (element: Element): boolean =>
  element.closest("dialog, .field") !== null ||
  (element.closest("[popover]") !== null && element.matches(":focus-visible"));

/** Takes the focus off a clicked button or select, or a dragged slider: it would catch the character's keys. */
export function freeFocus(): void {
  document.addEventListener("click", (click) => {
    const button = click.target instanceof HTMLElement ? click.target.closest("button") : null;
    if (button && click.detail > 0 && !keepsFocus(button)) button.blur();
  });
  document.addEventListener("change", ({ target }) => {
    if (target instanceof HTMLSelectElement && !keepsFocus(target)) target.blur();
  });
  document.addEventListener("pointerup", ({ target }) => {
    if (target instanceof HTMLInputElement && target.type === "range" && !keepsFocus(target)) target.blur();
  });
}
