/** The REST interface, as far as the page uses it; a refusal becomes an Error with the server's own words. */

import type { CharacterSummary, Edited, Edition, Finding, LogEntry, MachineInfo, MachineSummary, Mapping, SceneSummary, StageInfo, StateHistory } from "./protocol";

export class ApiError extends Error {
  constructor(
    readonly status: number,
    message: string,
    /** Which member or which place of a file is wrong, and why. */
    readonly places: readonly { field: string; message: string }[] = [],
    /** What the verifier has against an edit. */
    readonly findings: readonly Finding[] = [],
  ) {
    super(message);
  }
}

/** The server's problem+json in words: detail, else title, else the status. */
export function problemOf(status: number, body: unknown): ApiError {
  const { detail, title, errors, findings } = (body ?? {}) as Record<"detail" | "title" | "errors" | "findings", unknown>;
  const words = [detail, title].find((text) => typeof text === "string" && text);
  const places = Array.isArray(errors) ? (errors as { field: string; message: string }[]) : [];
  return new ApiError(status, typeof words === "string" ? words : `the server answered ${status}`, places, Array.isArray(findings) ? (findings as Finding[]) : []);
}

/** `version`: the one of a machine that an edit is based on. */
export async function call(method: string, path: string, body?: object, version?: number): Promise<Response> {
  const headers: Record<string, string> = version === undefined ? {} : { "if-match": `"${version}"` };
  const options: RequestInit = { method, headers };
  if (body) Object.assign(options, { headers: { ...headers, "content-type": "application/json" }, body: JSON.stringify(body) });
  const reply = await fetch(new URL(`api/${path}`, document.baseURI), options);
  if (!reply.ok) throw problemOf(reply.status, await reply.json().catch(() => ({})));
  return reply;
}

export async function read<T>(path: string): Promise<T> {
  return (await (await call("GET", path)).json()) as T;
}

export const id = encodeURIComponent;

/** What a cell is to say, as one writes it in the table; empty: blank. */
export interface NewCell {
  layer: string;
  state: string;
  event: string;
  text: string;
}

/** JSON lines or one JSON value with the entries in it. */
export function parseLog(text: string): LogEntry[] {
  const lines = text.trim().split("\n").filter(Boolean);
  const values: unknown[] = lines.flatMap((line) => {
    const value = JSON.parse(line) as unknown;
    return Array.isArray(value) ? value : [value];
  });
  return values.filter((value): value is LogEntry => typeof (value as LogEntry).tick === "number" && "kind" in (value as LogEntry));
}

export const machines = (): Promise<MachineSummary[]> => read("machines");
export const scenes = (): Promise<SceneSummary[]> => read("scenes");
export const machine = (name: string): Promise<MachineInfo> => read(`machines/${id(name)}`);
export const verify = (name: string): Promise<{ findings: Finding[] }> => read(`machines/${id(name)}/verify`);
export const versions = (name: string): Promise<Edition[]> => read(`machines/${id(name)}/versions`);
/** Changes a cell of a machine whose `version` was seen last; `dry`: only what would be said. */
export const patchCell = async (name: string, version: number, cell: NewCell, dry: boolean): Promise<Edited> =>
  (await (await call("PATCH", `machines/${id(name)}/cells${dry ? "?dry=true" : ""}`, cell, version)).json()) as Edited;
export const undo = async (name: string, version: number): Promise<Edited> => (await (await call("POST", `machines/${id(name)}/undo`, undefined, version)).json()) as Edited;
export const characters = (): Promise<CharacterSummary[]> => read("characters");
export const mapping = (character: string): Promise<Mapping> => read(`characters/${id(character)}/mapping`);
export const removeCharacter = (name: string): Promise<Response> => call("DELETE", `characters/${id(name)}`);
/** A machine of an uploaded character; clips whose state is empty are left out. */
export const makeMachine = (name: string, character: string, states: Record<string, string>): Promise<Response> =>
  call("POST", "machines", { name, character, mapping: states });
export const stage = (stageId: string): Promise<StageInfo> => read(`stages/${id(stageId)}`);
export const history = (stageId: string): Promise<StateHistory> => read(`stages/${id(stageId)}/history`);
export const log = async (stageId: string): Promise<LogEntry[]> => parseLog(await (await call("GET", `stages/${id(stageId)}/log`)).text());

/** A real-time stage with one actor of `machineName`; gives the new stage's id. */
export async function newStage(machineName: string): Promise<string> {
  const reply = await call("POST", "stages", { clock: "real", actors: [{ machine: machineName }] });
  return ((await reply.json()) as { id: string }).id;
}

/** A real-time stage furnished as a scene; gives the new stage's id. */
export async function newScene(scene: string): Promise<string> {
  return ((await (await call("POST", "stages", { clock: "real", scene })).json()) as { id: string }).id;
}

export const pause = (stageId: string, paused: boolean): Promise<Response> => call("POST", `stages/${id(stageId)}/pause`, { paused });
export const speed = (stageId: string, value: number): Promise<Response> => call("POST", `stages/${id(stageId)}/speed`, { speed: value });
export const step = (stageId: string, ticks: number): Promise<Response> => call("POST", `stages/${id(stageId)}/step`, { ticks });
export const remove = (stageId: string): Promise<Response> => call("DELETE", `stages/${id(stageId)}`);
