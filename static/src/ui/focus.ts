/** Keeps the keyboard free for the character. */

/**
 * Takes the focus off a clicked button or select, or a dragged slider: it would catch the character's keys. Fields of
 * a form keep it.
 */
export function freeFocus(): void {
  document.addEventListener("click", (click) => {
    const button = click.target instanceof HTMLElement ? click.target.closest("button") : null;
    if (click.detail > 0) button?.blur();
  });
  document.addEventListener("change", ({ target }) => {
    if (target instanceof HTMLSelectElement && !target.closest(".field")) target.blur();
  });
  document.addEventListener("pointerup", ({ target }) => {
    if (target instanceof HTMLInputElement && target.type === "range") target.blur();
  });
}
