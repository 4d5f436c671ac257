/** Reads texts of fields; throws errors with words for the user. */

/** Reads a number; blank: null, which takes the member away. */
export function numberOrNone(text: string): number | null {
  if (!text.trim()) return null;
  const value = Number(text);
  if (!Number.isFinite(value)) throw new Error("a number, or blank");
  return value;
}

/** Reads a number, or takes the text for the name of a parameter. */
export function numberOrName(text: string): number | string | null {
  const value = Number(text);
  return text.trim() && Number.isNaN(value) ? text.trim() : numberOrNone(text);
}

/** Reads names or numbers between commas. */
export const listed = (text: string): string[] =>
  text
    .split(",")
    .map((part) => part.trim())
    .filter(Boolean);

/** Writes a number without the noise of single precision. */
export const numberText = (value: number): string => String(Number(value.toPrecision(6)));
