/** The arrow keys in a menu. */

/** Moves the focus to the next or previous item of a menu; returns whether the key asked for it. */
export function stepThrough(menu: HTMLElement, { key }: KeyboardEvent): boolean {
  const items = [...menu.querySelectorAll<HTMLElement>("[role=menuitem]:not([disabled])")];
  const step = { ArrowDown: 1, ArrowUp: -1 }[key];
  if (step === undefined || !items.length) return false;
  const at = items.indexOf(document.activeElement as HTMLElement);
  items[(at + step + items.length) % items.length]!.focus();
  return true;
}
