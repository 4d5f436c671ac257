/** Puts a verdict into words. */

import type { Verdict } from "../../net/protocol";

/** Writes a verdict in one line. */
export function verdictLine({ verdict, event, from, to, reason }: Verdict): string {
  const taken = to ? `${from} → ${to}` : `stays in ${from}`;
  const way = verdict === "taken" ? taken : `${verdict} in ${from}`;
  return reason && verdict !== "taken" ? `${event}: ${way}, ${reason}` : `${event}: ${way}`;
}
