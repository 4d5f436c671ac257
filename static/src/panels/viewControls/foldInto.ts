/** Moves what has no room in a row into a box. */

/** Keeps `row` in one line: while the row is too narrow, moves its `groups` into `box`, in their order. */
export function foldInto(box: HTMLElement, row: HTMLElement, groups: readonly HTMLElement[]): void {
  const places = groups.map((group) => {
    const place = document.createComment("");
    group.before(place);
    return place;
  });
  const fit = (): void => {
    groups.forEach((group, k) => places[k]!.after(group));
    for (const group of groups) {
      if (row.scrollWidth <= row.clientWidth) break;
      box.prepend(group);
    }
  };
  new ResizeObserver(fit).observe(row);
}
