/** Finds names by some of their letters, the best match first. */

export interface Named {
  name: string;
  /** Words beside the name; they match, too. */
  note: string;
}

/** Ranks of a match: at the start, at the start of a word, inside; in the note; letters of the name with gaps. */
const [START, WORD, INSIDE, NOTE, LETTERS] = [0, 1, 2, 10, 15];

/** Returns the rank of `part` in `text`, null if `text` lacks its letters in their order. */
function rankIn(text: string, part: string): number | null {
  const at = text.indexOf(part);
  if (at === 0) return START;
  if (at > 0) return /[\s_.:-]/.test(text[at - 1]!) ? WORD : INSIDE;
  let from = 0;
  for (const letter of part) {
    from = text.indexOf(letter, from) + 1;
    if (from === 0) return null;
  }
  return LETTERS;
}

function rankOf({ name, note }: Named, parts: readonly string[]): number | null {
  let sum = 0;
  for (const part of parts) {
    const [inName, inNote] = [rankIn(name.toLowerCase(), part), note.toLowerCase().indexOf(part)];
    const rank = Math.min(inName ?? Infinity, inNote < 0 ? Infinity : NOTE);
    if (rank === Infinity) return null;
    sum += rank;
  }
  return sum;
}

/** Returns the items whose name or note has each typed word: best first, then shortest, else in their order. */
export function matching<T extends Named>(items: readonly T[], typed: string): T[] {
  const parts = typed.toLowerCase().split(/\s+/).filter(Boolean);
  const ranked = items.flatMap((item) => {
    const rank = rankOf(item, parts);
    return rank === null ? [] : [{ item, rank }];
  });
  if (parts.length) ranked.sort((a, b) => a.rank - b.rank || a.item.name.length - b.item.name.length);
  return ranked.map(({ item }) => item);
}
