/** Calls the part of the REST interface that names, forks and deletes stages. */

import { ask } from "./api";

export const rename = (stage_id: string, name: string) =>
  ask("patch", "/api/stages/{stage_id}", { stage_id }, { body: { name } });
/** Forks a stage at a tick; null: at its playhead. */
export const fork = (stage_id: string, tick: number | null, name: string) =>
  ask("post", "/api/stages/{stage_id}/fork", { stage_id }, { body: { tick, name } });
/** Compares two stages at a tick; null: in the newest ticks that both have. */
export const differences = (stage_id: string, other: string, tick: number | null) =>
  ask(
    "get",
    "/api/stages/{stage_id}/differences",
    { stage_id },
    { query: { with: other, ...(tick === null ? {} : { from: tick, to: tick }) } },
  );
