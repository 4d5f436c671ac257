/** Reads and writes the spans of phase in which a foot stands; throws errors with words for the user. */

export type Spans = [number, number][];
const NEVER = "never";
const EXAMPLE = `spans of phase, as in: 0–0.6, 0.9–1.1; or ${NEVER}; blank: as found from the clip`;

export function spansText(spans: readonly (readonly number[])[]): string {
  const text = ([first = 0, last = 0]: readonly number[]): string => `${short(first)}–${short(last)}`;
  return spans.length ? spans.map(text).join(", ") : NEVER;
}

/** Null: as found from the clip. */
export function spansOf(text: string): Spans | null {
  const words = text.trim();
  if (!words) return null;
  return words === NEVER ? [] : words.split(/[,;]/).map(spanOf);
}

function spanOf(text: string): [number, number] {
  const [, first, last] = /^\s*([\d.]+)\s*(?:–|-|to|…)\s*([\d.]+)\s*$/.exec(text) ?? [];
  const [begin, end] = [Number(first), Number(last)];
  if (!(begin >= 0 && begin <= 1 && end > begin && end <= begin + 1)) throw new Error(EXAMPLE);
  return [begin, end];
}

const short = (phase: number): string => String(Math.round(phase * 1000) / 1000);
