// @vitest-environment happy-dom
import { html } from "lit-html";
import { afterEach, expect, it, vi } from "vitest";
import * as api from "../../net/stages";
import { draw } from "../../ui/draw";
import { lossesPart } from "./losses";

afterEach(() => void vi.restoreAllMocks());

async function shown(losses: Awaited<ReturnType<typeof api.losses>>): Promise<string> {
  vi.spyOn(api, "losses").mockResolvedValue(losses);
  const host = document.createElement("div");
  const { read, part } = lossesPart();
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

it("says nothing while all came back", async () => {
  expect((await shown({ stages: [], other: [] })).trim()).toBe("");
});
