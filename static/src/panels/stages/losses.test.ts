// @vitest-environment happy-dom
import { html } from "lit-html";
import { afterEach, expect, it, vi } from "vitest";
import * as api from "../../net/stages";
import { draw } from "../../ui/draw";
import { lossesPart } from "./losses";

afterEach(() => {
  vi.restoreAllMocks();
  tell.mockReset();
  localStorage.clear();
});

const tell = vi.fn<(words: string) => void>();

async function shown(losses: Awaited<ReturnType<typeof api.losses>>): Promise<string> {
  vi.spyOn(api, "losses").mockResolvedValue(losses);
  const host = document.createElement("div");
  const { read, part } = lossesPart(tell);
  draw(host, () => html`${part()}`);
  await read();
  return host.textContent;
}

it("names the stages that did not come back, and what else is damaged", async () => {
  const why = "s1 is kept, and did not come back: its log is damaged";
  const text = await shown({
    stages: [{ id: "s1", why }],
    other: ["hand comes back without version 3: damaged"],
  });
  expect(text).toContain(why);
  expect(text).toContain("hand comes back without version 3");
});

it("tells of the same losses once", async () => {
  const losses = { stages: [], other: ["hand comes back without version 3: damaged"] };
  await shown(losses);
  await shown(losses);
  expect(tell).toHaveBeenCalledOnce();
});

it("says nothing while all came back", async () => {
  expect((await shown({ stages: [], other: [] })).trim()).toBe("");
  expect(tell).not.toHaveBeenCalled();
});
