/** What one may go on typing in a cell: names of states, and then the moment. */

import type { LayerInfo } from "../../net/protocol";

const MOST = 8;

/** The states a cell of `state` may lead to, as they are written there: its siblings in a sub-machine by their short names, first. */
export function targets({ states }: Pick<LayerInfo, "states">, state: string): string[] {
  const outer = states.find(({ name }) => name === state)?.outer ?? "";
  const siblings = outer ? states.filter((one) => one.outer === outer).map(({ name }) => name.slice(outer.length + 1)) : [];
  const outers = states.flatMap((one) => (one.outer && one.outer !== outer ? [one.outer] : []));
  const others = states.filter((one) => !outer || one.outer !== outer).map(({ name }) => name);
  return [...new Set([...siblings, ...others.filter((name) => !name.includes(".")), ...outers, ...others])];
}

/** The markers of the motion of `state`. */
export function markersOf({ states }: Pick<LayerInfo, "states">, state: string): string[] {
  return (states.find(({ name }) => name === state)?.markers ?? []).map(({ name }) => name);
}

/** Texts that begin as `text` does, the likeliest first; none where there is nothing to add. */
export function completions(text: string, names: readonly string[], markers: readonly string[]): string[] {
  const typed = text.trimStart().toLowerCase();
  const known = names.find((name) => typed.startsWith(name.toLowerCase()) && /^!?(\s|$)/.test(typed.slice(name.length)));
  if (known !== undefined) {
    const moments = ["end", ...markers].flatMap((moment) => [`${known} at ${moment}`, `${known}! at ${moment}`]);
    const all = [`${known}!`, ...moments].filter((one) => one.toLowerCase().startsWith(typed) && one.toLowerCase() !== typed);
    // A longer name that begins alike is as likely.
    const longer = names.filter((name) => name !== known && name.toLowerCase().startsWith(typed));
    return [...longer, ...all].slice(0, MOST);
  }
  const starting = names.filter((name) => name.toLowerCase().startsWith(typed));
  const within = typed ? names.filter((name) => !starting.includes(name) && name.toLowerCase().includes(typed)) : ["-"];
  return [...starting, ...within].slice(0, MOST);
}
