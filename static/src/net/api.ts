/** The REST interface, as far as the page uses it; a refusal becomes an Error with the server's own words. */

import type { LogEntry, MachineInfo, MachineSummary, StageInfo, StateHistory } from "./protocol";

export class ApiError extends Error {
  constructor(
    readonly status: number,
    message: string,
  ) {
    super(message);
  }
}

/** The server's problem+json in words: detail, else title, else the status. */
async function problem(reply: Response): Promise<ApiError> {
  const body = (await reply.json().catch(() => ({}))) as { detail?: unknown; title?: unknown };
  const words = [body.detail, body.title].find((text) => typeof text === "string" && text);
  return new ApiError(reply.status, typeof words === "string" ? words : `the server answered ${reply.status}`);
}

async function call(method: string, path: string, body?: object): Promise<Response> {
  const options: RequestInit = { method };
  if (body) Object.assign(options, { headers: { "content-type": "application/json" }, body: JSON.stringify(body) });
  const reply = await fetch(new URL(`api/${path}`, document.baseURI), options);
  if (!reply.ok) throw await problem(reply);
  return reply;
}

async function read<T>(path: string): Promise<T> {
  return (await (await call("GET", path)).json()) as T;
}

const id = encodeURIComponent;

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
export const machine = (name: string): Promise<MachineInfo> => read(`machines/${id(name)}`);
export const stage = (stageId: string): Promise<StageInfo> => read(`stages/${id(stageId)}`);
export const history = (stageId: string): Promise<StateHistory> => read(`stages/${id(stageId)}/history`);
export const log = async (stageId: string): Promise<LogEntry[]> => parseLog(await (await call("GET", `stages/${id(stageId)}/log`)).text());

/** A real-time stage with one actor of `machineName`; gives the new stage's id. */
export async function newStage(machineName: string): Promise<string> {
  const reply = await call("POST", "stages", { clock: "real", actors: [{ machine: machineName }] });
  return ((await reply.json()) as { id: string }).id;
}

export const pause = (stageId: string, paused: boolean): Promise<Response> => call("POST", `stages/${id(stageId)}/pause`, { paused });
export const speed = (stageId: string, value: number): Promise<Response> => call("POST", `stages/${id(stageId)}/speed`, { speed: value });
export const step = (stageId: string, ticks: number): Promise<Response> => call("POST", `stages/${id(stageId)}/step`, { ticks });
export const remove = (stageId: string): Promise<Response> => call("DELETE", `stages/${id(stageId)}`);
