/** Moves what has no room in a row into boxes. */

/** A phone shows the buttons of the boxes alone, in a corner: a row would lie over the character's legs. */
const PHONE = window.matchMedia("(max-width: 480px)");

/** What may be moved, and into which box. */
export type Fold = readonly [group: HTMLElement, box: HTMLElement];

/** Keeps `row` in one line: while the row is too narrow, moves groups into their boxes, the first one first. */
export function foldInto(row: HTMLElement, folds: readonly Fold[]): void {
  const places = folds.map(([group]) => {
    const place = document.createComment("");
    group.before(place);
    return place;
  });
  const fit = (): void => {
    folds.forEach(([group], k) => places[k]!.after(group));
    for (const [group, box] of folds) {
      if (!PHONE.matches && row.scrollWidth <= row.clientWidth) break;
      box.prepend(group);
    }
  };
  new ResizeObserver(fit).observe(row);
}
