/** Calls the REST interface; a refusal becomes an ApiError with the server's words. */

import type { Finding, LogHeader, LogLine, NewClip, Problem, Skinning } from "./protocol";
import type { NewCurves, NewRig, NewSolve } from "./types/api.generated";
import type { Answer, Extras, Method, Places, Route } from "./types/routes";

/** Bytes of a long answer: a table of 12,000 cells takes as long to read as to show, and the picture goes on between. */
const LONG = 1e6;
/** A hidden page does not draw. */
const LONGEST_DRAWING_MS = 100;

export class ApiError extends Error {
  constructor(
    readonly status: number,
    message: string,
    /** The wrong members of the request or places of a file, each with its reason. */
    readonly places: readonly { field: string; message: string }[] = [],
    /** The verifier's findings about a refused edit. */
    readonly findings: readonly Finding[] = [],
    /** Whether the server would take the same request later. */
    readonly passing = false,
  ) {
    super(message);
  }
}

/** Makes an error of a problem+json body: its words are the detail, else the title, else the status. */
export function problemOf(status: number, body: unknown, passing = false): ApiError {
  // Whatever stands between the page and the server may answer too: nothing of a problem is sure to be there.
  const { detail, title, errors, findings } = (body ?? {}) as Partial<Problem>;
  return new ApiError(
    status,
    detail || title || `the server answered ${status}`,
    errors ?? [],
    findings ?? [],
    passing,
  );
}

/** Fills the braces of a path: `/api/stages/{stage_id}` -> `/api/stages/main`. */
function filled(path: string, places: object, query: object): URL {
  const values = new Map(
    Object.entries(places).map(([name, value]) => [name, encodeURIComponent(String(value))]),
  );
  const url = new URL(
    path.slice(1).replace(/\{(\w+)\}/g, (_, name: string) => values.get(name) ?? ""),
    document.baseURI,
  );
  for (const [name, value] of Object.entries(query)) url.searchParams.set(name, String(value));
  return url;
}

/** What a request has beside its address. */
interface Sent {
  body?: object | undefined;
  version?: number;
  key?: string;
  viewer?: number | undefined;
  signal?: AbortSignal;
}

async function send(
  method: Method,
  url: URL,
  { body, version, key, viewer, signal }: Sent = {},
): Promise<Response> {
  const headers: Record<string, string> = version === undefined ? {} : { "if-match": `"${version}"` };
  if (key !== undefined) headers["idempotency-key"] = key;
  if (viewer !== undefined) headers["statwalk-viewer"] = String(viewer);
  // After Back a browser answers from its cache without asking, unless it is told to ask.
  const options: RequestInit = {
    method: method.toUpperCase(),
    headers,
    cache: "no-cache",
    keepalive: method === "delete", // a page that is closed still takes away what it has left
    ...(signal && { signal }),
  };
  if (body)
    Object.assign(options, {
      headers: { ...headers, "content-type": "application/json" },
      body: JSON.stringify(body),
    });
  const reply = await fetch(url, options);
  if (!reply.ok)
    throw problemOf(reply.status, await reply.json().catch(() => ({})), reply.headers.has("retry-after"));
  return reply;
}

/** Waits until the browser has drawn, or for a moment if it does not draw. */
function drawing(): Promise<void> {
  return new Promise((done) => {
    setTimeout(done, LONGEST_DRAWING_MS);
    requestAnimationFrame(() => setTimeout(done));
  });
}

/** Sends a request to a route; returns its JSON. */
export async function ask<M extends Method, P extends Route<M>>(
  method: M,
  path: P,
  places: Places<M, P>,
  extras: Extras<M, P> = {},
): Promise<Answer<M, P>> {
  const { query, ...sent } = extras;
  const reply = await send(method, filled(path, places as object, query ?? {}), sent);
  const answer = (reply.status === 204 ? undefined : await reply.json()) as Answer<M, P>;
  if (Number(reply.headers.get("content-length")) > LONG) await drawing();
  return answer;
}

/** Reads the file of a stage's posed frame at `tick`; `skinning`: of all characters, null: each its own. */
export async function frameFile(
  stage_id: string,
  tick: number,
  skinning: Skinning | null,
): Promise<ArrayBuffer> {
  const query = skinning === null ? { tick } : { tick, skinning };
  const reply = await send("get", filled("/api/stages/{stage_id}/frame.glb", { stage_id }, query));
  return reply.arrayBuffer();
}

/** Reads a log: JSON lines, or one JSON array. */
export function parseLog(text: string): LogLine[] {
  const lines = text.trim().split("\n").filter(Boolean);
  const values = lines.map((line) => JSON.parse(line) as LogHeader | LogLine);
  return values.filter((value) => "kind" in value);
}

/** Interpolates key rotations by several interpolations. */
export const compareCurves = (body: NewCurves) => ask("post", "/api/curves", {}, { body });
export const machines = () => ask("get", "/api/machines", {});
export const scenes = () => ask("get", "/api/scenes", {});
export const machine = (name: string) => ask("get", "/api/machines/{name}", { name });
export const verify = (name: string, signal: AbortSignal) =>
  ask("get", "/api/machines/{name}/verify", { name }, { signal });
/** Plays every transition and measures it; takes seconds. */
export const measure = (name: string) => ask("get", "/api/machines/{name}/measure", { name });
export const feet = (name: string) => ask("get", "/api/machines/{name}/feet", { name });
/** Asks the twelve rules of inverse kinematics about the text of a file. */
export const deduce = (file: string) => ask("post", "/api/deduce", {}, { body: { file } });
/** Solves a chain of a character's pose; nothing on a stage changes. */
export const solve = (name: string, body: NewSolve) =>
  ask("post", "/api/characters/{name}/solve", { name }, { body });
export const characters = () => ask("get", "/api/characters", {});
export const formats = (name: string) => ask("get", "/api/characters/{name}/formats", { name });
export const mapping = (name: string) => ask("get", "/api/characters/{name}/mapping", { name });
export const removeCharacter = (name: string) => ask("delete", "/api/characters/{name}", { name });
export const character = (name: string) => ask("get", "/api/characters/{name}", { name });
/** Reads the model of a character, as the server keeps it. */
export const storedModel = async (name: string): Promise<Blob> =>
  (await send("get", filled("/api/characters/{name}/model.glb", { name }, {}))).blob();
/** Reads how alike left and right move in a clip. */
export const twinning = (name: string, clip: string) =>
  ask("get", "/api/characters/{name}/twinning", { name }, { query: { clip } });
export const bones = (name: string) => ask("get", "/api/characters/{name}/bones", { name });
/** Carries a clip of another character over to character `name`. */
export const carryClip = (name: string, body: NewClip) =>
  ask("post", "/api/characters/{name}/clips", { name }, { body });
/** Gives character `name` a skeleton and a skin; takes seconds. */
export const rig = (name: string, body: NewRig, signal: AbortSignal) =>
  ask("post", "/api/characters/{name}/rig", { name }, { body, signal });
/** Reads what this browser may do. */
export const access = () => ask("get", "/api/access", {});
export const stages = () => ask("get", "/api/stages", {});
export const stage = (stage_id: string) => ask("get", "/api/stages/{stage_id}", { stage_id });
export const history = (stage_id: string) => ask("get", "/api/stages/{stage_id}/history", { stage_id });
export const log = async (stageId: string): Promise<LogLine[]> =>
  parseLog(await (await send("get", filled("/api/stages/{stage_id}/log", { stage_id: stageId }, {}))).text());

/** Makes a real-time stage with one actor of a machine, or from a scene; returns the stage's id. */
export const newStage = async (opening: { machine: string } | { scene: string }): Promise<string> => {
  const begin = "scene" in opening ? opening : { actors: [opening] };
  return (await ask("post", "/api/stages", {}, { body: { clock: "real", ...begin } })).id;
};

/** Makes a stage that moves only by steps, with one actor of a machine. */
export const manualStage = (machine: string, name: string) =>
  ask("post", "/api/stages", {}, { body: { clock: "manual", seed: 0, name, actors: [{ machine }] } });

export const pause = (stage_id: string, paused: boolean, viewer?: number) =>
  ask("post", "/api/stages/{stage_id}/pause", { stage_id }, { body: { paused }, viewer });
export const speed = (stage_id: string, value: number, viewer?: number) =>
  ask("post", "/api/stages/{stage_id}/speed", { stage_id }, { body: { speed: value }, viewer });
export const step = (stage_id: string, ticks: number, viewer?: number) =>
  ask("post", "/api/stages/{stage_id}/step", { stage_id }, { body: { ticks }, viewer });
export const remove = (stage_id: string) => ask("delete", "/api/stages/{stage_id}", { stage_id });
