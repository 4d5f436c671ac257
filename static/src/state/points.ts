/** The points and directions among the parameters of a machine. */

import type { MachineInfo } from "../net/protocol";

export type Point = [number, number, number];
/** The parameters of a character that looks at the pointer. */
export const [GAZE, LOOK] = ["gaze", "look"] as const;

/** A parameter that a handle in the scene can set. */
export interface Aim {
  kind: "point" | "direction";
  start: Point;
  /** Whether the numbers are in model space, else on the stage. */
  isModel: boolean;
  /** The joint from which the page draws a direction; empty: the middle of the actor. */
  joint: string;
}

/** The points and directions of a machine with their defaults; the first solver that reads one gives its space. */
export function aimsOf(machine: MachineInfo | null): Map<string, Aim> {
  const aims = new Map<string, Aim>();
  for (const { name, kind, vector, default: standard } of machine?.parameters ?? []) {
    if (kind !== "point" && kind !== "direction") continue;
    const aim = aims.get(vector) ?? { kind, start: [0, 0, 0], ...readBy(machine!, vector) };
    aim.start["xyz".indexOf(name.slice(-1))] = standard;
    aims.set(vector, aim);
  }
  return aims;
}

function readBy({ solvers }: MachineInfo, name: string): Pick<Aim, "isModel" | "joint"> {
  const solver = solvers.find(({ target, pole }) => name === target || name === pole);
  const joint = solver?.target === name ? solver.end : solver?.start;
  return { isModel: solver?.space === "model", joint: joint ?? "" };
}

/** Where the handle of a point waits: at the free end of the chain that takes hold when you drag it. */
export interface Grip {
  joint: string;
  /** The parameter that is 1 while the handle is dragged, else 0. */
  weight: string;
}

/** The grips of a machine, by point. */
export function gripsOf(machine: MachineInfo | null): Map<string, Grip> {
  return new Map(
    (machine?.solvers ?? []).flatMap(({ grab, target, weight, start, end, anchor }) =>
      grab && typeof weight === "string" ? [[target, { joint: anchor === end ? start : end, weight }]] : [],
    ),
  );
}

/** The points that solvers with a weight by state reach for in a state of the base. */
export function reachedIn(machine: MachineInfo | null, state: string): Set<string> {
  const solvers = machine?.solvers ?? [];
  const outer = new Map((machine?.states ?? []).map(({ name, outer }) => [name, outer]));
  const isReached = (weight: (typeof solvers)[number]["weight"]): boolean => {
    if (typeof weight !== "object") return false;
    let name: string | undefined = state;
    while (name && !(name in weight)) name = outer.get(name);
    return !!name && weight[name] !== 0;
  };
  return new Set(solvers.filter(({ weight }) => isReached(weight)).map(({ target }) => target));
}

/** Whether a machine's character can look at the pointer: it has a point `gaze` and a weight `look`. */
export function canLook(machine: MachineInfo | null): boolean {
  return aimsOf(machine).get(GAZE)?.kind === "point" && machine!.parameters.some(({ name }) => name === LOOK);
}
