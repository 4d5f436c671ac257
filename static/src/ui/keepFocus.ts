/** Keeps the keyboard's place in a form whose entries come, go and change their names. */

/**
 * Watches where the focus is in `host`. The returned function puts it back if what had it is gone: on the same
 * control of the entry that now stands there, else on the head of the section.
 */
export function keepFocus(host: HTMLElement): () => void {
  let place: { control: HTMLElement; section: HTMLElement; entry: number; label: number } | null = null;
  host.addEventListener("focusin", ({ target }) => {
    const control = target as HTMLElement;
    const section = control.closest<HTMLElement>("details");
    const entry = control.closest<HTMLElement>("fieldset");
    if (!section) return;
    place = {
      control,
      section,
      entry: entry ? entriesOf(section).indexOf(entry) : -1,
      label: entry ? controlsOf(entry).indexOf(control) : -1,
    };
  });
  // The removal of what has the focus brings no event; a move of the focus out of the form does.
  host.addEventListener("focusout", ({ relatedTarget }) => {
    if (relatedTarget instanceof Node && !host.contains(relatedTarget)) place = null;
  });
  return () => {
    if (!place || host.contains(place.control)) return;
    const { section, entry, label } = place;
    const next = entriesOf(section)[entry];
    ((next && controlsOf(next)[label]) ?? section.querySelector("summary"))?.focus();
  };
}

const entriesOf = (section: HTMLElement) => [...section.querySelectorAll<HTMLElement>("fieldset")];
const controlsOf = (entry: HTMLElement) => [
  ...entry.querySelectorAll<HTMLElement>("input, select, textarea, button"),
];
