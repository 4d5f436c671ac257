/** The sections about the machine as a whole: what it is called, and what cells take that say nothing. */

import type { MachineInfo, Operation } from "../../net/protocol";
import type { Section } from "./entries";
import { numberOrName, numberOrNone, numberText } from "../../state/fieldTexts";

const CURVES = [
  ["cubic", "cubic"],
  ["quintic", "quintic: softer at its end"],
] as const;
const MOMENTS = [
  ["now", "at once"],
  ["end", "at the end of the motion"],
] as const;

export function aboutSection(machine: MachineInfo): Section {
  const { title, description, idle, fallback, foot_lock, events, states } = machine;
  const set = (fields: Extract<Operation, { kind: "set_machine" }>["fields"]): Operation[] => [
    { kind: "set_machine", fields },
  ];
  const choices = (names: readonly string[], none: string) =>
    [["", none], ...names.map((name) => [name, name] as const)] as const;
  const orNone = (text: string): string | null => text.trim() || null;
  const sent = events.filter((event) => event !== "END");
  return {
    title: "about",
    entries: [
      {
        name: "machine",
        fields: [
          { label: "title", value: title, means: (text) => set({ title: orNone(text) }) },
          {
            label: "description",
            value: description,
            lines: 3,
            means: (text) => set({ description: orNone(text) }),
          },
          {
            label: "idle event",
            value: idle ?? "",
            choices: choices(sent, "none"),
            means: (text) => set({ idle: orNone(text) }),
          },
          {
            label: "fallback",
            value: fallback,
            choices: choices(
              states.map(({ name }) => name),
              "the first state",
            ),
            means: (text) => set({ fallback: orNone(text) }),
          },
          {
            label: "feet hold",
            value: typeof foot_lock === "number" ? (foot_lock ? numberText(foot_lock) : "") : foot_lock,
            hint: "0…1, or a parameter: planted feet stay",
            proposals: [
              "1",
              ...machine.parameters.filter(({ kind }) => kind === "number").map(({ name }) => name),
            ],
            means: (text) => set({ foot_lock: numberOrName(text) }),
          },
        ],
      },
    ],
  };
}

export function defaultsSection({ defaults }: MachineInfo): Section {
  const { when, blend, curve, buffer } = defaults;
  const set = (fields: Extract<Operation, { kind: "set_defaults" }>["fields"]): Operation[] => [
    { kind: "set_defaults", fields },
  ];
  const blends = (seconds: number | null, along: string): Operation[] =>
    set({ blend: seconds === null || along === "cubic" ? seconds : { seconds, curve: "quintic" } });
  return {
    title: "defaults",
    entries: [
      {
        name: "defaults",
        fields: [
          { label: "fires", value: when, choices: MOMENTS, means: (text) => set({ when: text }) },
          {
            label: "blend, s",
            value: numberText(blend),
            number: true,
            step: 0.05,
            means: (text) => blends(numberOrNone(text), curve),
          },
          { label: "curve", value: curve, choices: CURVES, means: (text) => blends(blend, text) },
          {
            label: "waits, s",
            value: numberText(buffer),
            number: true,
            step: 0.05,
            means: (text) => set({ buffer: numberOrNone(text) }),
          },
        ],
      },
    ],
  };
}
