/** What each route of the REST interface takes and answers, read off the generated description. */

import type { paths } from "./api.generated";

export type Method = "get" | "post" | "put" | "patch" | "delete";
/** The paths that know a method. */
export type Route<M extends Method> = {
  [P in keyof paths]: paths[P] extends Record<M, object> ? P : never;
}[keyof paths];

type Operation<M extends Method, P extends Route<M>> = paths[P] extends Record<M, infer O> ? O : never;
type Json<Content> = Content extends { content: { "application/json": infer Body } } ? Body : never;

/** The JSON that a route answers; never where it answers none. */
export type Answer<M extends Method, P extends Route<M>> =
  Operation<M, P> extends { responses: infer All } ? Json<All[keyof All]> : never;
/** The JSON that a route takes. */
export type Body<M extends Method, P extends Route<M>> =
  Operation<M, P> extends { requestBody?: infer One } ? Json<NonNullable<One>> : undefined;
/** What fills the braces of a path. */
export type Places<M extends Method, P extends Route<M>> =
  Operation<M, P> extends { parameters: { path: infer All } } ? All : object;
/** What comes after the question mark. */
export type Query<M extends Method, P extends Route<M>> =
  Operation<M, P> extends { parameters: { query?: infer All } } ? All : undefined;

/**
 * A request beside its path; `version` is that of the machine that an edit is based on; requests with the same `key`
 * count once; `viewer` is the number of this page among the stage's viewers.
 */
export interface Extras<M extends Method, P extends Route<M>> {
  query?: Query<M, P>;
  body?: Body<M, P>;
  version?: number;
  key?: string;
  viewer?: number | undefined;
  signal?: AbortSignal;
}
