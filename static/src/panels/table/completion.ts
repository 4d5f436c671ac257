/** Completes the text of a cell: names of states, then the timing. */

import type { LayerInfo } from "../../net/protocol";

const MOST = 8;

/**
 * Returns the states that a cell of `state` can name; siblings in a sub-machine come first, by their short
 * names.
 */
export function targets({ states }: Pick<LayerInfo, "states">, state: string): string[] {
  const outer = states.find(({ name }) => name === state)?.outer ?? "";
  const siblings = outer
    ? states.filter((other) => other.outer === outer).map(({ name }) => name.slice(outer.length + 1))
    : [];
  const outers = states.flatMap((other) => (other.outer && other.outer !== outer ? [other.outer] : []));
  const others = states.filter((other) => !outer || other.outer !== outer).map(({ name }) => name);
  return [...new Set([...siblings, ...others.filter((name) => !name.includes(".")), ...outers, ...others])];
}

/** Returns the markers of the motion of `state`. */
export function markersOf({ states }: Pick<LayerInfo, "states">, state: string): string[] {
  return (states.find(({ name }) => name === state)?.markers ?? []).map(({ name }) => name);
}

/** Returns completions of `text`, the likeliest first. */
export function completions(text: string, names: readonly string[], markers: readonly string[]): string[] {
  const typed = text.trimStart().toLowerCase();
  const known = names.find(
    (name) => typed.startsWith(name.toLowerCase()) && /^!?(\s|$)/.test(typed.slice(name.length)),
  );
  if (known !== undefined) {
    const moments = ["end", ...markers].flatMap((moment) => [
      `${known} at ${moment}`,
      `${known}! at ${moment}`,
    ]);
    const all = [`${known}!`, ...moments].filter(
      (completion) => completion.toLowerCase().startsWith(typed) && completion.toLowerCase() !== typed,
    );
    // A longer name with this beginning is as likely.
    const longer = names.filter((name) => name !== known && name.toLowerCase().startsWith(typed));
    return [...longer, ...all].slice(0, MOST);
  }
  const starting = names.filter((name) => name.toLowerCase().startsWith(typed));
  const within = typed
    ? names.filter((name) => !starting.includes(name) && name.toLowerCase().includes(typed))
    : ["-"];
  return [...starting, ...within].slice(0, MOST);
}
