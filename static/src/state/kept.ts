/** Keeps values in this browser. */

/** Returns what is kept at a place; `otherwise` if nothing is kept there that `isRight` accepts. */
export function kept<Value>(
  place: string,
  isRight: (value: unknown) => value is Value,
  otherwise: Value,
): Value {
  try {
    const value: unknown = JSON.parse(localStorage.getItem(place) ?? "null");
    return isRight(value) ? value : otherwise;
  } catch {
    return otherwise;
  }
}

/** A browser that keeps nothing has the value until the page is closed. */
export function keep(place: string, value: unknown): void {
  try {
    localStorage.setItem(place, JSON.stringify(value));
  } catch {
    return;
  }
}
