/** Calls the part of the REST interface that names, forks and deletes stages. */

import { ask } from "./api";

export const rename = (stage_id: string, name: string) =>
  ask("patch", "/api/stages/{stage_id}", { stage_id }, { body: { name } });
/** Lists what the last start of the server did not bring back. */
export const losses = () => ask("get", "/api/losses", {});
/** Forks a stage at a tick; null: at its playhead. */
export const fork = (stage_id: string, tick: number | null, name: string) =>
  ask("post", "/api/stages/{stage_id}/fork", { stage_id }, { body: { tick, name } });
/** The ticks to compare; without them the newest that both stages have. `with_from`: where the others begin. */
export interface ComparedTicks {
  from?: number;
  to?: number;
  with_from?: number;
  space?: "stage" | "model";
}

/** Compares two stages, or two spans of one. */
export const differences = (stage_id: string, other: string, ticks: ComparedTicks) =>
  ask("get", "/api/stages/{stage_id}/differences", { stage_id }, { query: { with: other, ...ticks } });
