/** The section of parameters: numbers, flags, points, directions and rotations. */

import type { MachineInfo, Operation, Parameter } from "../../net/protocol";
import { type Entry, type EntryField, movedUp, type Section } from "./entries";
import { listed, numberOrNone, numberText } from "../../state/fieldTexts";

type Kind = Parameter["kind"];
type Fields = Extract<Operation, { kind: "set_parameter" }>["fields"];

const DEFAULTS: Record<Kind, number | number[]> = {
  number: 0,
  flag: 0,
  point: [0, 0, 0],
  direction: [0, 0, 1],
  rotation: [0, 0, 0, 1],
};
const KINDS = (Object.keys(DEFAULTS) as Kind[]).map((kind) => [kind, kind] as const);

/** A parameter as the file has it: a vector with all its components. */
interface Whole extends Pick<Parameter, "kind" | "minimum" | "maximum" | "smooth" | "joint" | "freedom"> {
  name: string;
  event: string;
  values: number[];
}

/** Puts the components of vectors together. */
export function wholes(parameters: readonly Parameter[]): Whole[] {
  const found = new Map<string, Whole>();
  for (const parameter of parameters) {
    const name = parameter.vector || parameter.name;
    const known = found.get(name);
    if (known) known.values.push(parameter.default);
    else found.set(name, { ...parameter, name, values: [parameter.default] });
  }
  return [...found.values()];
}

export function parameterSection({ parameters }: MachineInfo): Section {
  const all = wholes(parameters);
  return {
    title: "parameters",
    entries: all.map((whole, i) => entry(whole, all, i)),
    add: {
      hint: "pace",
      means: (name) => [{ kind: "add_parameter", name, fields: { default: 0, min: 0, max: 1 } }],
    },
  };
}

function entry(whole: Whole, all: readonly Whole[], at: number): Entry {
  const { name } = whole;
  const place = { section: "parameters", name } as const;
  return {
    name,
    rename: (to) => [{ kind: "rename_parameter", name, to }],
    fields: fieldsOf(whole, (fields) => [{ kind: "set_parameter", name, fields }]),
    ...movedUp(all, at, (before) => ({ kind: "move_entry", ...place, before })),
    remove: [{ kind: "delete_entry", ...place }],
  };
}

function fieldsOf(whole: Whole, set: (fields: Fields) => Operation[]): EntryField[] {
  const { kind, values, minimum, maximum, smooth } = whole;
  const bounds: EntryField[] = [
    {
      label: "least",
      value: numberText(minimum),
      means: (text) => set({ min: numberOrNone(text) }),
    },
    {
      label: "most",
      value: numberText(maximum),
      means: (text) => set({ max: numberOrNone(text) }),
    },
  ];
  return [
    {
      label: "kind",
      value: kind,
      choices: KINDS,
      means: (text) => set(ofKind(text as Kind)),
    },
    {
      label: "default",
      value: values.map(numberText).join(", "),
      means: (text) => set({ default: defaultOf(kind, text) }),
    },
    ...(kind === "number" ? bounds : []),
    ...(kind === "flag"
      ? []
      : [
          {
            label: "smooth, s",
            value: numberText(smooth),
            means: (text: string) => set({ smooth: numberOrNone(text) }),
          },
        ]),
    ...(kind === "number" ? [handle(whole, set)] : []),
  ];
}

/** Returns what another kind needs: a default of its own, and bounds only of a number. */
function ofKind(kind: Kind): Fields {
  const bounds = kind === "number" ? { min: 0, max: 1 } : { min: null, max: null };
  const smooth = kind === "flag" ? { smooth: null } : {};
  return {
    kind: kind === "number" ? null : kind,
    default: DEFAULTS[kind],
    ...bounds,
    ...smooth,
    handle: null,
  };
}

function defaultOf(kind: Kind, text: string): number | number[] | null {
  const length = [DEFAULTS[kind]].flat().length;
  const numbers = listed(text).map(Number);
  if (numbers.length !== length || numbers.some(Number.isNaN))
    throw new Error(length === 1 ? "one number" : `${length} numbers with commas between them`);
  return length === 1 ? numbers[0]! : numbers;
}

/** The field of a handle: the page shows it at a joint. */
function handle({ joint, freedom, event }: Whole, set: (fields: Fields) => Operation[]): EntryField {
  return {
    label: "handle",
    value: [joint, freedom, event].filter(Boolean).join(", "),
    hint: "none; Elbow, flexion",
    means: (text) => {
      const [at, moves, sent] = listed(text);
      if (!at) return set({ handle: null });
      if (!moves) throw new Error("a joint and its freedom, as in: Elbow, flexion");
      return set({ handle: { joint: at, freedom: moves, ...(sent && { event: sent }) } });
    },
  };
}
