// @vitest-environment happy-dom
import { describe, expect, it } from "vitest";
import { pitchOf, Sounds } from "./sounds";

it("is silent until somebody asks for sound, and remembers the answer", () => {
  expect(new Sounds().muted).toBe(true);
  new Sounds().muted = false;
  expect(new Sounds().muted).toBe(false);
});

describe("the pitch of an action", () => {
  it("is the same for the same name", () => expect(pitchOf("collect")).toBe(pitchOf("collect")));
  it("lies within two octaves", () => {
    for (const name of ["", "jump", "land", "collect", "ouch", "鳥", "x".repeat(500)]) {
      expect(pitchOf(name)).toBeGreaterThanOrEqual(330);
      expect(pitchOf(name)).toBeLessThan(4 * 330);
    }
  });
  it("tells most names apart", () =>
    expect(new Set(["jump", "land", "collect", "ouch", "open", "shut"].map(pitchOf)).size).toBeGreaterThan(
      3,
    ));
});
