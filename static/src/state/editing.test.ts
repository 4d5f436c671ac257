// @vitest-environment happy-dom
import { signal } from "@preact/signals-core";
import { beforeEach, expect, test, vi } from "vitest";
import type { MachineInfo } from "../net/protocol";
import { finding } from "../net/types/examples";
import { Editing } from "./editing";
import { Event } from "./event";
import type { WatchedMachine } from "./watchedMachine";

/** The signals of the checks that were asked for, oldest first. */
let checks: AbortSignal[];

beforeEach(() => {
  checks = [];
  vi.stubGlobal("fetch", (url: URL, { signal }: RequestInit) => {
    if (url.pathname.endsWith("/verify") && signal) checks.push(signal);
    return new Promise(() => undefined);
  });
});

const machine = (name: string): MachineInfo => ({ name, version: 1 }) as MachineInfo;
const storage = { getItem: () => null, setItem: () => undefined };

function editing(): { editing: Editing; info: { value: MachineInfo | null } } {
  const info = signal<MachineInfo | null>(machine("old"));
  const take = (edited: MachineInfo): void => void (info.value = edited);
  return { editing: new Editing({ info, take } as unknown as WatchedMachine, new Event(), storage), info };
}

test("the check of a machine ends when another machine is shown", () => {
  const { info } = editing();
  info.value = machine("new");
  expect(checks.map((check) => check.aborted)).toEqual([true, false]);
});

test("the findings about a machine go when another machine is shown", async () => {
  const answer = (): Response =>
    Response.json({ findings: [finding({ message: "about old" })], versions: [] });
  vi.stubGlobal("fetch", () => Promise.resolve(answer()));
  const { editing: shown, info } = editing();
  await vi.waitFor(() => expect(shown.verified.value).toMatchObject([{ message: "about old" }]));
  vi.stubGlobal("fetch", () => new Promise(() => undefined));
  info.value = machine("new");
  expect(shown.verified.value).toBeNull();
});

test("the check of a machine that is about to go is given up", () => {
  editing().editing.abandon();
  expect(checks.map((check) => check.aborted)).toEqual([true]);
});

/** Answers each text with the next version; returns the versions that the texts named. */
function matchedVersions(): (string | null)[] {
  const matched: (string | null)[] = [];
  vi.stubGlobal("fetch", (_url: URL, { method, headers }: RequestInit) => {
    if (method !== "PUT") return new Promise(() => undefined);
    matched.push(new Headers(headers).get("If-Match"));
    return Promise.resolve(
      Response.json({ name: "old", version: matched.length + 1, result: "kept", findings: [] }),
    );
  });
  return matched;
}

test("a text that was typed while another one was on its way goes on from it", async () => {
  const matched = matchedVersions();
  const { editing: typed } = editing();
  await Promise.all([typed.text("first", 1, false), typed.text("second", 1, false)]);
  expect(matched).toEqual(['"1"', '"2"']);
});

test("a text of a machine that was made anew goes on from nothing before", async () => {
  const matched = matchedVersions();
  const { editing: typed, info } = editing();
  await typed.text("of the machine before", 1, false);
  info.value = machine("old");
  await typed.text("of the new machine", 1, false);
  expect(matched).toEqual(['"1"', '"1"']);
});
