/** Requests about one actor of a stage: why, why not, the way to a state, and a parameter set. */

import { call, id, read } from "./api";
import type { Plan, Why, WhyNot } from "./explained";

const place = (stage: string, actor: number, what: string): string => `stages/${id(stage)}/actors/${actor}/${what}`;

export const why = (stage: string, actor: number, tick: number): Promise<Why> => read(place(stage, actor, `why?tick=${tick}`));
export const whyNot = (stage: string, actor: number, event: string, tick: number): Promise<WhyNot> =>
  read(place(stage, actor, `whynot?event=${id(event)}&tick=${tick}`));
export const travel = async (stage: string, actor: number, state: string): Promise<Plan> =>
  (await (await call("POST", place(stage, actor, "travel"), { state })).json()) as Plan;
export const cancelTravel = (stage: string, actor: number): Promise<Response> => call("DELETE", place(stage, actor, "travel"));
export const setParameter = (stage: string, actor: number, parameter: string, value: number): Promise<Response> =>
  call("POST", `stages/${id(stage)}/parameters`, { parameter, value, actor });
