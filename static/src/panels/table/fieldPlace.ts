/** Where a field lies while it edits a cell. */

/** Pixels. */
const [MOST_WIDTH, LETTER_WIDTH, PADDING] = [170, 9, 20];

/** Puts a field over its cell; no wider than its text needs, so that you can click the cells beside it. */
export function coverCell(field: HTMLInputElement, cell: HTMLElement, host: HTMLElement): void {
  const wanted = Math.min(MOST_WIDTH, host.clientWidth, field.value.length * LETTER_WIDTH + PADDING);
  const width = Math.max(cell.offsetWidth, wanted);
  const left = Math.min(cell.offsetLeft, Math.max(0, host.scrollWidth - width));
  Object.assign(field.style, {
    left: `${left}px`,
    top: `${cell.offsetTop}px`,
    width: `${width}px`,
    height: `${cell.offsetHeight}px`,
  });
}
