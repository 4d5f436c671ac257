/** Keeps the keyboard free for the character. */

/** A dialog keeps its focus: behind it the character has no keys. */
const isInDialog = (element: Element): boolean => element.closest("dialog") !== null;

/** Takes the focus off a clicked button or select, or a dragged slider: it would catch the character's keys. */
export function freeFocus(): void {
  document.addEventListener("click", (click) => {
    const button = click.target instanceof HTMLElement ? click.target.closest("button") : null;
    if (button && click.detail > 0 && !isInDialog(button)) button.blur();
  });
  document.addEventListener("change", ({ target }) => {
    if (target instanceof HTMLSelectElement && !isInDialog(target)) target.blur();
  });
  document.addEventListener("pointerup", ({ target }) => {
    if (target instanceof HTMLInputElement && target.type === "range" && !isInDialog(target)) target.blur();
  });
}
