/** Keeps a field in sight while it is used. */

const isNews = ({ target, addedNodes }: MutationRecord): boolean =>
  (target as Element).matches(".field-error") ||
  [...addedNodes].some((node) => node instanceof HTMLFieldSetElement);

/**
 * Scrolls `host` to the focused field and the error below the field: when the error changes, and when a new entry of the
 * form moves the field.
 */
export function keepInSight(host: HTMLElement): void {
  const follow = (changes: readonly MutationRecord[]): void => {
    const field = document.activeElement?.closest(".field");
    if (field && host.contains(field) && changes.some(isNews)) field.scrollIntoView({ block: "nearest" });
  };
  new MutationObserver(follow).observe(host, {
    subtree: true,
    childList: true,
    attributes: true,
    attributeFilter: ["hidden"],
  });
}
