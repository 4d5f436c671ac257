/** How long the blend lasts that a verdict begins. */

import type { MachineInfo, Verdict } from "./net/protocol";

/** Ticks; 0 where no motion begins, or where `machine` does not say. */
export function blendTicks(machine: MachineInfo | null, { verdict, layer, from, event, to }: Verdict, rate: number): number {
  if (verdict !== "taken" || !to) return 0;
  const cell = machine?.layers[layer]?.table[from ?? ""]?.[event];
  const outcome = cell?.alternatives?.find((one) => one.to === to) ?? cell;
  return Math.round((outcome?.blend ?? 0) * rate);
}
