/** Sends requests about one actor of a stage: why, whynot, travel, parameters. */

import { ask } from "./api";

export const why = (stage_id: string, actor_id: number, tick: number) =>
  ask("get", "/api/stages/{stage_id}/actors/{actor_id}/why", { stage_id, actor_id }, { query: { tick } });
export const whyNot = (stage_id: string, actor_id: number, event: string, tick: number) =>
  ask(
    "get",
    "/api/stages/{stage_id}/actors/{actor_id}/whynot",
    { stage_id, actor_id },
    { query: { event, tick } },
  );
export const travel = (stage_id: string, actor_id: number, state: string) =>
  ask("post", "/api/stages/{stage_id}/actors/{actor_id}/travel", { stage_id, actor_id }, { body: { state } });
export const cancelTravel = (stage_id: string, actor_id: number) =>
  ask("delete", "/api/stages/{stage_id}/actors/{actor_id}/travel", { stage_id, actor_id });
export const setParameter = (stage_id: string, actor: number, parameter: string, value: number) =>
  ask("post", "/api/stages/{stage_id}/parameters", { stage_id }, { body: { parameter, value, actor } });
export const sendEvent = (stage_id: string, actor: number, event: string) =>
  ask("post", "/api/stages/{stage_id}/events", { stage_id }, { body: { event, actor } });
/** Returns the facts of an actor at the playhead. */
export const actorFacts = (stage_id: string, actor_id: number) =>
  ask("get", "/api/stages/{stage_id}/actors/{actor_id}", { stage_id, actor_id });
