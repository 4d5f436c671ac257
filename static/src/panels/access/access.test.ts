import { expect, it } from "vitest";
import type { Access } from "../../net/protocol";
import { accessWords } from "./access";

const live = { state: "live", detail: "live" } as const;
const access = (role: Access["role"], stage: string | null = null): Access => ({
  token_needed: true,
  name: "ada",
  role,
  stage,
});

it("says what you may do unless it is everything", () => {
  expect(
    [null, access("view"), access("view", "a"), access("drive"), access("drive", "a"), access("admin")].map(
      (one) => accessWords(one, live),
    ),
  ).toEqual([
    "",
    "you may only look",
    "you may only look",
    "you may look and drive",
    "you may drive this stage",
    "",
  ]);
});

it("says why the server lets you in no more", () => {
  expect(accessWords(access("admin"), { state: "refused", detail: "no token" })).toBe("no token");
});
