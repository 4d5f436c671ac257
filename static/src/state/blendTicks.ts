/** Finds the length of the blend that a verdict starts. */

import type { MachineInfo, Verdict } from "../net/protocol";

/** Returns ticks; 0 if no motion starts, or if `machine` does not have the cell. */
export function blendTicks(
  machine: MachineInfo | null,
  { verdict, layer, from, event, to }: Verdict,
  rate: number,
): number {
  if (verdict !== "taken" || !to) return 0;
  const cell = machine?.layers[layer]?.table[from]?.[event];
  const alternative = cell?.alternatives.find((choice) => choice.to === to) ?? cell;
  return Math.round((alternative?.blend ?? 0) * rate);
}
