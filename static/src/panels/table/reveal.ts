/** Scrolls the table, not the page, as little as needed until a row or a cell is visible. */

import { firstFrom } from "./gridMoves";

/** The height of the head, which covers rows: pixels. */
const HEAD = 32;

/** A table, what scrolls it, and the cells of its head; the first column stays in place. */
export interface Scrolled {
  host: HTMLElement;
  table: HTMLElement;
  heads: readonly HTMLElement[];
}

export function reveal(host: HTMLElement, row: HTMLElement): void {
  const [top, bottom] = [row.offsetTop - HEAD, row.offsetTop + row.offsetHeight];
  if (top < host.scrollTop) host.scrollTop = top;
  else if (bottom > host.scrollTop + host.clientHeight) host.scrollTop = bottom - host.clientHeight;
}

/** Scrolls sideways until the cell is visible, and no column is cut by the first one. */
export function revealSideways({ host, table, heads: [fixed, ...heads] }: Scrolled, cell: HTMLElement): void {
  const stays = fixed?.offsetWidth ?? 0;
  const { scrollLeft, clientWidth } = host;
  const [left, right] = [cell.offsetLeft - stays, cell.offsetLeft + cell.offsetWidth];
  if (cell.tagName === "TH" || left < scrollLeft) host.scrollLeft = Math.max(0, left);
  else if (right > scrollLeft + clientWidth) {
    const starts = heads.map((head) => head.offsetLeft - stays);
    const start = firstFrom(starts, Math.min(left, right - clientWidth));
    // Without room after the last column the table could not be scrolled so far.
    const last = heads.at(-1)!;
    const missing = start + clientWidth - (last.offsetLeft + last.offsetWidth);
    table.style.paddingRight = `${Math.max(0, missing)}px`;
    host.scrollLeft = start;
  }
}
