// @vitest-environment happy-dom

import { afterEach, beforeEach, expect, test, vi } from "vitest";

import { ApiError } from "./api";
import { redo, restore, undo } from "./edits";
import { copy, fromCharacter, fromNothing, rename } from "./machines";

interface Seen {
  method: string;
  path: string;
  key: string;
}

/** Answers requests in turn, the last answer again and again; notes what came. */
function answered(...answers: (Error | Response)[]): Seen[] {
  const seen: Seen[] = [];
  vi.stubGlobal(
    "fetch",
    (url: URL, { method, headers }: { method: string; headers: Record<string, string> }) => {
      const answer = answers[Math.min(seen.length, answers.length - 1)];
      seen.push({ method, path: url.pathname, key: headers["idempotency-key"] ?? "" });
      return answer instanceof Error ? Promise.reject(answer) : Promise.resolve(answer?.clone());
    },
  );
  return seen;
}

const lost = new TypeError("Failed to fetch");
const fine = (): Response => Response.json({});
const busy = (): Response => new Response("{}", { status: 503, headers: { "retry-after": "1" } });

beforeEach(() => vi.useFakeTimers());
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

test("what changes a machine, or makes one, is sent again with its key until the server has answered", async () => {
  const requests = [
    () => undo("m", 3),
    () => redo("m", 3),
    () => restore("m", 3, 1),
    () => copy("n", "m"),
    () => fromNothing("n"),
    () => fromCharacter("n", "robot", {}),
    () => rename("m", "n"),
  ];
  const keys = new Set<string>();
  for (const request of requests) {
    const seen = answered(lost, busy(), fine());
    const answer = request();
    await vi.runAllTimersAsync();
    await answer;
    expect(seen).toHaveLength(3);
    expect(new Set(seen.map(({ method, path, key }) => `${method} ${path} ${key}`)).size).toBe(1);
    keys.add(seen[0]?.key ?? "");
  }
  expect(keys.size).toBe(requests.length);
  expect(keys.has("")).toBe(false);
});

test("a refusal is an answer, and a server that stays away is said", async () => {
  const refused = answered(new Response("{}", { status: 409 }));
  await expect(undo("m", 3)).rejects.toBeInstanceOf(ApiError);
  expect(refused).toHaveLength(1);

  const away = answered(lost);
  const answer = expect(undo("m", 3)).rejects.toBe(lost);
  await vi.runAllTimersAsync();
  await answer;
  expect(away).toHaveLength(10);
});
