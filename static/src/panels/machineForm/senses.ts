/** The section of senses: events that a condition or a touch raises. */

import type { MachineInfo, Operation, Sense } from "../../net/protocol";
import type { Entry, EntryField, Section } from "./entries";
import { listed } from "../../state/fieldTexts";

type Fields = Extract<Operation, { kind: "set_sense" }>["fields"];
const MOMENTS = [
  ["enter", "when it begins"],
  ["stay", "as long as it lasts"],
  ["leave", "when it ends"],
] as const;

export function senseSection({ senses }: MachineInfo): Section {
  return {
    title: "senses",
    entries: Object.entries(senses).map(([name, sense], i, all) => entry(name, sense, all[i - 1]?.[0])),
    add: { hint: "NEAR: distance < 2", means: newSense },
  };
}

/** Reads `NEAR: distance < 2`, or `HIT: touch hand, ball`. */
export function newSense(text: string): Operation[] {
  const [, name, said] = /^([^\s:]+)\s*:\s*(.+)$/.exec(text) ?? [];
  if (!name || !said) throw new Error("an event and its condition, as in: NEAR: distance < 2");
  const touch = /^touch\s+(.+)$/.exec(said)?.[1];
  return [{ kind: "add_sense", name, fields: touch === undefined ? { when: said } : { touch: pair(touch) } }];
}

function pair(text: string): [string, string] {
  const [own, other] = listed(text);
  if (!own || !other) throw new Error("two colliders, as in: hand, ball");
  return [own, other];
}

function entry(name: string, sense: Sense, before: string | undefined): Entry {
  const set = (fields: Fields): Operation[] => [{ kind: "set_sense", name, fields }];
  const place = { section: "senses", name } as const;
  return {
    name,
    rename: (to) => [{ kind: "rename_event", event: name, to }],
    fields: "when" in sense ? conditionFields(sense, set) : touchFields(sense, set),
    ...(before !== undefined && { earlier: [{ kind: "move_entry", ...place, before }] }),
    remove: [{ kind: "delete_entry", ...place }],
  };
}

const conditionFields = (
  { when, release }: Extract<Sense, { when: string }>,
  set: (fields: Fields) => Operation[],
): EntryField[] => [
  { label: "when", value: when, means: (text) => set({ when: text.trim() }) },
  {
    label: "again after",
    value: release,
    hint: "it was false",
    means: (text) => set({ release: text.trim() || null }),
  },
];

const touchFields = (
  { touch, on }: Exclude<Sense, { when: string }>,
  set: (fields: Fields) => Operation[],
): EntryField[] => [
  { label: "touch", value: touch.join(", "), means: (text) => set({ touch: pair(text) }) },
  {
    label: "raised",
    value: on,
    choices: MOMENTS,
    means: (text) => set({ on: text as (typeof MOMENTS)[number][0] }),
  },
];
