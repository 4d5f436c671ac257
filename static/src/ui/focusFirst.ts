/** Begins a form: its first field has the focus. */

/**
 * Focuses the first element in `box` that fits the selector. The text of a field is selected, as it is only proposed:
 * typing replaces it.
 */
export function focusFirst(box: HTMLElement, selector: string): void {
  const first = box.querySelector<HTMLElement>(selector);
  first?.focus();
  if (first instanceof HTMLInputElement) first.select();
}
