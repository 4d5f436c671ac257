/** Keeps in this browser what its user is called. */

const PLACE = "statwalk.name";

/** Returns the kept name; empty: none is kept. */
export function keptName(): string {
  try {
    return localStorage.getItem(PLACE) ?? "";
  } catch {
    return "";
  }
}

/** A browser that keeps nothing has the name until the page is closed. */
export function keepName(name: string): void {
  try {
    localStorage.setItem(PLACE, name);
  } catch {
    return;
  }
}
