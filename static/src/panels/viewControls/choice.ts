/** A choice of names that follows a signal, and sets it. */

import type { Signal } from "@preact/signals-core";
import { el } from "../../ui/dom";

export function choice<Name extends string>(
  label: string,
  title: string,
  names: readonly Name[],
  chosen: Signal<Name>,
  choose = (name: Name): void => void (chosen.value = name),
): HTMLSelectElement {
  const options = names.map((name) => el("option", { value: name }, name));
  const select = el("select", { "aria-label": label, title }, ...options);
  select.addEventListener("change", () => choose(select.value as Name));
  chosen.subscribe((name) => (select.value = name));
  return select;
}
