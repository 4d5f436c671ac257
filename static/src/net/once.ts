/** Sends requests that count once: each has a key, and is sent again with it until the server has answered. */

import { ApiError, ask } from "./api";
import type { Answer, Extras, Method, Places, Route } from "./types/routes";

const MOST_TRIES = 10;
const REST_MS = 700;

/** Makes a key; `crypto.randomUUID` is only there over https. */
export const newKey = (): string =>
  Array.from(crypto.getRandomValues(new Uint32Array(4)), (part) => part.toString(36)).join("-");

/** Returns whether a request got no answer: the server is away or busy, or a proxy answered in its place. */
export function isUnheard(error: unknown): boolean {
  if (error instanceof ApiError) return error.passing || error.status === 502 || error.status === 504;
  return error instanceof TypeError;
}

/** Sends a request that changes something, at most `MOST_TRIES` times; returns its JSON. */
export async function askOnce<M extends Method, P extends Route<M>>(
  method: M,
  path: P,
  places: Places<M, P>,
  extras: Extras<M, P> = {},
): Promise<Answer<M, P>> {
  const key = newKey();
  for (let tries = 1; ; tries++) {
    try {
      return await ask(method, path, places, { ...extras, key });
    } catch (error) {
      if (!isUnheard(error) || tries === MOST_TRIES) throw error;
    }
    await new Promise((done) => setTimeout(done, REST_MS));
  }
}
