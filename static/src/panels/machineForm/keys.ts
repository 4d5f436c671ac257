/** The section of keys: events that a key sends, or parameters that it moves. */

import type { KeyBinding, MachineInfo, Operation } from "../../net/protocol";
import { listed, numberText } from "../../state/fieldTexts";
import { type Entry, type EntryField, movedUp, type Section } from "./entries";

type Fields = Extract<Operation, { kind: "set_key" }>["fields"];
type Rates = KeyBinding["change"];

const ANY_STATE = "*";
const MOMENTS = [
  ["press", "once, when it goes down"],
  ["hold", "as long as it is down"],
] as const;

export function keySection({ keys, events }: MachineInfo): Section {
  const all = Object.entries(keys).map(([name, binding]) => ({ name, binding }));
  return {
    title: "keys",
    entries: all.map(({ name, binding }, i) => ({
      ...entry(name, binding, events, all[i + 1]?.name),
      ...movedUp(all, i, (before) => ({ kind: "move_entry", section: "keys", name, before })),
    })),
    add: { hint: "j: JUMP, or w: hold FORWARD", means: newKey },
  };
}

/** Reads `j: JUMP`, `w: hold FORWARD`, or `x: change pace 0.5`. */
export function newKey(text: string): Operation[] {
  const [, name, said] = /^(\S[^\s:]*)\s*:\s*(.+)$/.exec(text) ?? [];
  if (!name || !said) throw new Error("a key and its event, as in: j: JUMP");
  const [, kind, rest] = /^(hold|change)\s+(.+)$/.exec(said) ?? [];
  const fields = kind === "change" ? { change: ratesOf(rest!) } : { [kind ?? "press"]: rest ?? said };
  return [{ kind: "add_key", name, fields }];
}

function entry(
  name: string,
  binding: KeyBinding,
  events: readonly string[],
  next: string | undefined,
): Entry {
  const set = (fields: Fields): Operation[] => [{ kind: "set_key", name, fields }];
  const remove: Operation = { kind: "delete_entry", section: "keys", name };
  const renamed = (to: string): Operation => {
    const place = next === undefined ? {} : { before: next };
    return { kind: "add_key", name: to, fields: fieldsOf(binding), ...place };
  };
  return {
    name,
    rename: (to) => [remove, renamed(to)],
    fields: binding.press === null ? [changeField(binding.change, set)] : eventFields(binding, events, set),
    remove: [remove],
  };
}

/** Returns the members of a key in the file. */
function fieldsOf({ press, hold, release, change }: KeyBinding): Fields {
  if (press === null) return { change };
  return { [hold ? "hold" : "press"]: press, ...(release !== null && { release }) };
}

function eventFields(
  { press, hold, release }: KeyBinding,
  events: readonly string[],
  set: (fields: Fields) => Operation[],
): EntryField[] {
  const choices = events.filter((event) => event !== "END").map((event) => [event, event] as const);
  const sent = hold ? "hold" : "press";
  return [
    { label: "sends", value: press!, choices, means: (event) => set({ [sent]: event }) },
    {
      label: "sends it",
      value: sent,
      choices: MOMENTS,
      means: (moment) => set({ press: null, hold: null, [moment]: press }),
    },
    {
      label: "released",
      value: release ?? "",
      choices: [["", "nothing more"], ...choices],
      means: (event) => set({ release: event || null }),
    },
  ];
}

const changeField = (change: Rates, set: (fields: Fields) => Operation[]): EntryField => ({
  label: "moves, a second",
  value: ratesText(change),
  means: (text) => set({ change: ratesOf(text) }),
});

/** Writes `pace 0.5`, or by state `REACH: aim.x 0.7, aim.y 1; POINT: aim.x 0.5`. */
function ratesText(change: Rates): string {
  return Object.entries(change)
    .map(([state, rates]) => {
      const words = Object.entries(rates).map(([name, rate]) => `${name} ${numberText(rate)}`);
      return (state === ANY_STATE ? "" : `${state}: `) + words.join(", ");
    })
    .join("; ");
}

/** Reads what `ratesText` writes. */
function ratesOf(text: string): Rates {
  const groups = text.split(";").map((group) => {
    const [, state, rates] = /^\s*(?:([^\s:]+)\s*:)?(.+)$/.exec(group) ?? [];
    return [state ?? ANY_STATE, Object.fromEntries(listed(rates ?? "").map(rateOf))] as const;
  });
  return Object.fromEntries(groups);
}

function rateOf(text: string): [string, number] {
  const [name, rate, ...more] = text.split(/\s+/);
  if (!name || !rate || more.length || Number.isNaN(Number(rate)))
    throw new Error("parameters and how much they move in a second, as in: pace 0.5, aim.x -1");
  return [name, Number(rate)];
}
