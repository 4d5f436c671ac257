// @vitest-environment happy-dom
import { expect, test, vi } from "vitest";
import { cast, machine } from "../net/types/examples";
import { Event } from "./event";
import type { Selection } from "./selection";
import { WatchedMachine } from "./watchedMachine";

/** A page that has made version 2, of a server whose newest version is `newest`; and what the page asks for. */
function edited(newest: number): { watched: WatchedMachine; asked: string[] } {
  const asked: string[] = [];
  vi.stubGlobal("fetch", ({ pathname }: URL) => {
    asked.push(pathname.split("/").at(-1)!);
    const isList = pathname.endsWith("/versions");
    return Promise.resolve(Response.json(isList ? [{ version: newest }] : machine({ version: newest })));
  });
  const selection = { cast: cast({ version: 7 }), layer: { value: 0 } } as unknown as Selection;
  const watched = new WatchedMachine(selection, new Event());
  watched.take(machine({ version: 1 }), 6);
  watched.answered = () => {
    watched.take(machine({ version: 2 }));
    return Promise.resolve();
  };
  return { watched, asked };
}

test("a machine that this page has edited is not fetched again when the stage plays it", async () => {
  const { watched, asked } = edited(2);
  await watched.load();
  await watched.load();
  expect([asked, watched.info.value?.version]).toEqual([["versions"], 2]);
});

test("another editor's newer version is fetched", async () => {
  const { watched, asked } = edited(3);
  await watched.load();
  expect([asked.length, watched.info.value?.version]).toEqual([2, 3]);
});

test("a machine of a server that started again is fetched", async () => {
  const { watched, asked } = edited(2);
  watched.doubt();
  await watched.load();
  expect(asked).toEqual([machine({}).name]);
});
